// Fails, naming the service, when a compose file is not what the published schema says (an unknown key is a fault), or when a service
// is less confined than it should be: root written to, capabilities kept, memory without bound, ports beyond loopback, images whose tag
// moves, a file that is mounted but not there.
//
// Usage: node check_compose.mjs COMPOSE_FILE
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import path from "node:path";
import Ajv from "ajv";
import formats from "ajv-formats";
import yaml from "js-yaml";

// The published schema travels with a linter for such files. Ajv knows the draft by another address than the schema names.
const linter = path.dirname(path.dirname(fileURLToPath(import.meta.resolve("dclint"))));
const { $schema, ...schema } = JSON.parse(readFileSync(path.join(linter, "schemas", "compose.schema.json"), "utf8"));

function faults_of_service(name, service, folder) {
    const found = [], want = (good, what) => good || found.push(`${name}: ${what}`);
    want(service.read_only === true, "its root can be written to");
    want(service.cap_drop?.includes("ALL") && !service.cap_add, "keeps capabilities");
    want(service.security_opt?.includes("no-new-privileges:true"), "may gain privileges");
    want(!service.privileged && !service.network_mode && !service.pid, "shares the machine");
    want(/^[1-9]\d*:/.test(service.user ?? ""), "names no user, or root");
    want(service.mem_limit && service.pids_limit, "no bound of memory or processes");
    want(/:(?!latest$)[^:]+$/.test(service.image ?? ""), `image ${service.image} has no tag, or one that moves`);
    for (const port of service.ports ?? []) want(/^127\.0\.0\.1:/.test(port), `port ${port} is published beyond loopback`);
    for (const volume of service.volumes ?? []) {
        const [source, , mode] = volume.split(":");
        if (!source.startsWith(".")) continue;
        want(mode === "ro", `${source} can be written to`);
        want(existsSync(path.join(folder, source)), `${source} is not there`);
    }
    return found;
}

export function faults(compose, folder) {
    const check = formats(new Ajv({ allErrors: true, strict: false })).compile(schema);
    if (!check(compose)) return check.errors.map(e => `${e.instancePath} ${e.message} ${e.params.additionalProperty ?? ""}`.trimEnd());
    return Object.entries(compose.services).flatMap(([name, service]) => faults_of_service(name, service, folder));
}

export const parse = text => yaml.load(text);

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
    const file = process.argv[2];
    const compose = parse(readFileSync(file, "utf8"));
    const found = faults(compose, path.dirname(file));
    for (const fault of found) console.log(fault);
    console.log(`compose: ${Object.keys(compose.services).length} services, ${found.length} faults`);
    process.exit(found.length ? 1 : 0);
}
