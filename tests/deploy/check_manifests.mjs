// Reads the output of `kubectl kustomize` and names the object and field of each fault: fields that
// Kubernetes would reject or ignore, and pods with missing confinement or a too short grace period.
//
// Usage: kubectl kustomize FOLDER | node check_manifests.mjs
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import Ajv from "ajv";
import formats from "ajv-formats";
import yaml from "js-yaml";
import { model_of, schemas_of } from "./kubernetes_schema.mjs";

const name_of = object => `${object?.kind} ${object?.metadata?.name}`;

async function faults_of_schema(object) {
    const ajv = formats(new Ajv({ allErrors: true, strict: false }));
    const model = model_of(object);
    let schemas;
    try {
        schemas = await schemas_of(model);
    } catch {
        return [`${name_of(object)}: unknown kind ${object.apiVersion} ${object.kind}`];
    }
    for (const schema of schemas.values()) ajv.addSchema(schema);
    const check = ajv.getSchema(model);
    if (check(object)) return [];
    return check.errors.map(e => `${name_of(object)}: ${e.instancePath || "/"} ${e.message} ${e.params.additionalProperty ?? ""}`.trimEnd());
}

// Requirements of the Pod Security Standard "restricted", a read-only root file system and resource
// limits.
function faults_of_confinement(where, pod) {
    const found = [], require = (good, what) => good || found.push(`${where}: ${what}`);
    const security = pod.securityContext ?? {};
    require(security.runAsNonRoot === true && security.runAsUser > 0, "runs as root");
    require(security.seccompProfile?.type === "RuntimeDefault", "no seccompProfile RuntimeDefault");
    require(pod.automountServiceAccountToken === false, "automountServiceAccountToken is not false");
    require(!pod.hostNetwork && !pod.hostPID && !pod.hostIPC, "shares a namespace with its node");
    for (const volume of pod.volumes ?? []) require(!volume.hostPath, `volume ${volume.name} is a hostPath`);
    for (const container of pod.containers) {
        const own = container.securityContext ?? {};
        require(own.allowPrivilegeEscalation === false, "allowPrivilegeEscalation is not false");
        require(own.readOnlyRootFilesystem === true, "the root file system is writable");
        require(own.capabilities?.drop?.includes("ALL") && !own.capabilities.add, "capabilities are not dropped");
        require(container.resources?.requests?.cpu && container.resources.limits?.memory, "no CPU request or no memory limit");
        require(!/(:latest|^[^:]+)$/.test(container.image), `image ${container.image} has no fixed tag`);
        for (const probe of ["startupProbe", "readinessProbe", "livenessProbe"])
            require(container[probe]?.grpc || container[probe]?.exec, `no ${probe} with the gRPC health service or --health`);
    }
    return found;
}

const includes = (labels, selector) => Object.entries(selector ?? {}).every(([key, value]) => labels?.[key] === value);

// Names and labels by which objects refer to each other.
function faults_of_references(objects) {
    const found = [], of_kind = kind => objects.filter(o => o.kind === kind);
    const sets = of_kind("StatefulSet"), labels = sets.map(s => s.spec.template.metadata.labels);
    const selects = (object, selector) => {
        if (!selector || !Object.keys(selector).length || !labels.some(l => includes(l, selector)))
            found.push(`${name_of(object)}: the selector matches no pod`);
    };
    for (const kind of ["Service", "PodDisruptionBudget", "NetworkPolicy"]) {
        if (!of_kind(kind).length) found.push(`${kind} is missing`);
        for (const object of of_kind(kind)) {
            const spec = object.spec;
            selects(object, kind === "Service" ? spec.selector : (spec.selector ?? spec.podSelector)?.matchLabels);
        }
    }
    for (const set of sets) {
        selects(set, set.spec.selector.matchLabels);
        const pod = set.spec.template.spec;
        const ports = pod.containers.flatMap(c => c.ports.map(p => p.name));
        if (!of_kind("Service").some(s => s.metadata.name === set.spec.serviceName && s.spec.clusterIP === "None"))
            found.push(`${name_of(set)}: no headless Service ${set.spec.serviceName}`);
        if (!of_kind("ServiceAccount").some(a => a.metadata.name === pod.serviceAccountName))
            found.push(`${name_of(set)}: no ServiceAccount ${pod.serviceAccountName}`);
        for (const service of of_kind("Service"))
            for (const port of service.spec.ports)
                if (!ports.includes(port.targetPort)) found.push(`${name_of(service)}: no container has a port ${port.targetPort}`);
        for (const mount of pod.containers.flatMap(c => c.volumeMounts))
            if (![...pod.volumes, ...claims_of(set).map(c => ({ name: c.metadata.name }))].some(v => v.name === mount.name)) found.push(`${name_of(set)}: no volume ${mount.name}`);
    }
    return found;
}

const claims_of = set => set.spec.volumeClaimTemplates ?? [];

// The database must be on a volume of the server's own, and the UDP port must be reachable.
function faults_of_settings(objects) {
    const found = [], require = (good, what) => good || found.push(`jostle-server.toml: ${what}`);
    const settings = objects.find(o => o.kind === "ConfigMap" && o.data?.["jostle-server.toml"])?.data["jostle-server.toml"] ?? "";
    const database = /^\[persistence\]\ndatabase = "(.*)\/[^/"]+"/m.exec(settings)?.[1];
    const datagrams = Number(/^\[datagrams\]\nlisten = ".*:(\d+)"/m.exec(settings)?.[1]);
    for (const set of objects.filter(o => o.kind === "StatefulSet")) {
        const containers = set.spec.template.spec.containers, mounts = containers.flatMap(c => c.volumeMounts);
        const claims = claims_of(set).map(c => c.metadata.name);
        require(database && mounts.some(m => m.mountPath === database && !m.readOnly && claims.includes(m.name)),
            "persistence.database is not on a volume of volumeClaimTemplates, so worlds end with their pod");
        const port = containers.flatMap(c => c.ports).find(p => p.containerPort === datagrams && p.protocol === "UDP");
        require(port, "datagrams.listen has no UDP port in the container");
        require(objects.some(o => o.kind === "Service" && o.spec.ports.some(p => p.targetPort === port?.name && p.protocol === "UDP")),
            "datagrams.listen has no UDP port in a Service");
        require(objects.some(o => o.kind === "NetworkPolicy" && o.spec.ingress.some(i => i.ports.some(p => p.port === port?.name && p.protocol === "UDP"))),
            "the NetworkPolicy does not admit datagrams.listen");
    }
    return found;
}

// The server exits at the latest 3 s after its drain timeout, so the grace period must be longer.
function faults_of_grace_period(objects) {
    const settings = objects.find(o => o.kind === "ConfigMap" && o.data?.["jostle-server.toml"]);
    const drain = Number(/^drain_timeout_seconds = (\d+)/m.exec(settings?.data["jostle-server.toml"] ?? "")?.[1] ?? 5);
    return objects.filter(o => o.kind === "StatefulSet" && !(o.spec.template.spec.terminationGracePeriodSeconds >= drain + 4))
        .map(o => `${name_of(o)}: terminationGracePeriodSeconds is less than drain_timeout_seconds (${drain}) + 4`);
}

export async function faults(objects) {
    const found = [];
    for (const object of objects) found.push(...await faults_of_schema(object));
    if (found.length) return found;  // the later checks require a valid form
    const sets = objects.filter(o => o.kind === "StatefulSet");
    if (!sets.length) found.push("StatefulSet is missing");
    for (const set of sets) found.push(...faults_of_confinement(name_of(set), set.spec.template.spec));
    return [...found, ...faults_of_references(objects), ...faults_of_grace_period(objects), ...faults_of_settings(objects)];
}

export const parse = text => yaml.loadAll(text).filter(object => object);

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
    const objects = parse(readFileSync(0, "utf8"));
    const found = await faults(objects);
    for (const fault of found) console.log(fault);
    console.log(`manifests: ${objects.length} objects, ${found.length} faults`);
    process.exit(found.length || !objects.length ? 1 : 0);
}
