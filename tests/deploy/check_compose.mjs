// Checks a compose file and names the service of each fault: violations of the published schema (an
// unknown key is a fault), and missing confinement, such as a writable root, retained capabilities,
// unlimited memory, ports beyond loopback, images without a fixed tag, or a mounted file that does
// not exist.
//
// Usage: node check_compose.mjs COMPOSE_FILE
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath, pathToFileURL } from "node:url";
import path from "node:path";
import Ajv from "ajv";
import formats from "ajv-formats";
import yaml from "js-yaml";

// The published schema is part of a linter for compose files. Ajv knows the JSON schema draft by
// another URL than the schema.
const linter = path.dirname(path.dirname(fileURLToPath(import.meta.resolve("dclint"))));
const { $schema, ...schema } = JSON.parse(readFileSync(path.join(linter, "schemas", "compose.schema.json"), "utf8"));

function faults_of_service(name, service, folder) {
    const found = [], require = (good, what) => good || found.push(`${name}: ${what}`);
    require(service.read_only === true, "the root file system is writable");
    require(service.cap_drop?.includes("ALL") && !service.cap_add, "capabilities are not dropped");
    require(service.security_opt?.includes("no-new-privileges:true"), "no-new-privileges is not set");
    require(!service.privileged && !service.network_mode && !service.pid, "shares a namespace with the host");
    require(/^[1-9]\d*:/.test(service.user ?? ""), "user is missing or root");
    require(service.mem_limit && service.pids_limit, "mem_limit or pids_limit is missing");
    require(/:(?!latest$)[^:]+$/.test(service.image ?? ""), `image ${service.image} has no fixed tag`);
    for (const port of service.ports ?? []) require(/^127\.0\.0\.1:/.test(port), `port ${port} is published beyond loopback`);
    for (const volume of service.volumes ?? []) {
        const [source, , mode] = volume.split(":");
        if (!source.startsWith(".")) continue;
        require(mode === "ro", `${source} is mounted writable`);
        require(existsSync(path.join(folder, source)), `${source} does not exist`);
    }
    return found;
}

// The server's database must be on a named volume, and its UDP port published.
function faults_of_persistence(compose, folder) {
    const found = [], server = compose.services.server, volumes = server?.volumes ?? [];
    const file = volumes.find(v => v.includes(":/etc/jostle/jostle-server.toml"))?.split(":")[0];
    const settings = file && existsSync(path.join(folder, file)) ? readFileSync(path.join(folder, file), "utf8") : "";
    const database = /^\[persistence\]\ndatabase = "(.*)\/[^/"]+"/m.exec(settings)?.[1];
    if (!database || !volumes.some(v => v.split(":")[1] === database && v.split(":")[0] in (compose.volumes ?? {})))
        found.push("server: persistence.database is not on a named volume, so worlds end with the container");
    const datagrams = /^\[datagrams\]\nlisten = ".*:(\d+)"/m.exec(settings)?.[1];
    if (!datagrams || !(server.ports ?? []).some(p => p.endsWith(`:${datagrams}/udp`))) found.push("server: the UDP port of datagrams.listen is not published");
    return found;
}

export function faults(compose, folder) {
    const check = formats(new Ajv({ allErrors: true, strict: false })).compile(schema);
    if (!check(compose)) return check.errors.map(e => `${e.instancePath} ${e.message} ${e.params.additionalProperty ?? ""}`.trimEnd());
    return [...Object.entries(compose.services).flatMap(([name, service]) => faults_of_service(name, service, folder)),
        ...faults_of_persistence(compose, folder)];
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
