// JSON schemas of Kubernetes objects that forbid unknown fields. They come from the official
// JavaScript client, whose models are generated from the published OpenAPI description: a model
// lists its fields and their types, and its declarations list the optional fields.
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import path from "node:path";

const client = path.dirname(fileURLToPath(import.meta.resolve("@kubernetes/client-node")));
const models = path.join(client, "gen", "models");

// "apps/v1", "StatefulSet" -> "V1StatefulSet"; "v1", "Service" -> "V1Service"
export function model_of(object) {
    const version = String(object.apiVersion).split("/").pop();
    return version[0].toUpperCase() + version.slice(1) + object.kind;
}

function schema_of_type(type, format) {
    const list = /^Array<(.*)>$/.exec(type);
    if (list) return { type: "array", items: schema_of_type(list[1], format) };
    const map = /^\{ \[key: string\]: (.*); \}$/.exec(type);
    if (map) return { type: "object", additionalProperties: schema_of_type(map[1], format) };
    switch (type) {
        case "string": return { type: "string" };
        case "boolean": return { type: "boolean" };
        case "number": return { type: format === "double" ? "number" : "integer" };
        case "Date": return { type: "string", format: "date-time" };
        case "IntOrString": return { type: ["integer", "string"] };
        case "any": case "object": return {};
        default: return { $ref: `${type}` };
    }
}

// The schemas of a model and of all models that it refers to.
export async function schemas_of(name, schemas = new Map()) {
    if (schemas.has(name)) return schemas;
    const file = path.join(models, `${name}.js`);
    const model = (await import(file))[name];
    const optional = new Set([...readFileSync(path.join(models, `${name}.d.ts`), "utf8").matchAll(/^ {4}'(.+?)'\?: /gm)].map(m => m[1]));
    const fields = model.getAttributeTypeMap();
    schemas.set(name, {
        $id: name,
        type: "object",
        properties: Object.fromEntries(fields.map(f => [f.baseName, schema_of_type(f.type, f.format)])),
        required: fields.filter(f => !optional.has(f.name)).map(f => f.baseName),
        additionalProperties: false,
    });
    for (const field of fields)
        for (const [mentioned] of field.type.matchAll(/\b[A-Z]\w*V\d\w*|\bV\d\w*/g)) await schemas_of(mentioned, schemas);
    return schemas;
}
