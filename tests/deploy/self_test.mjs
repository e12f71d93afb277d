// The checks of this folder find what they are for: each fault is put into good files, one at a time, and must be named.
//
// Usage: node self_test.mjs MANIFESTS COMPOSE_FILE    (MANIFESTS: what `kubectl kustomize` printed)
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import * as compose from "./check_compose.mjs";
import * as manifests from "./check_manifests.mjs";

const [, , manifest_file, compose_file] = process.argv;
const objects = manifests.parse(readFileSync(manifest_file, "utf8"));
const composed = compose.parse(readFileSync(compose_file, "utf8"));
let count = 0;

// Each change takes the objects by kind and spoils them; one of the faults found must say so.
async function finds(wanted, spoil) {
    const copy = structuredClone(objects);
    spoil(kind => copy.find(o => o.kind === kind), copy);
    const found = await manifests.faults(copy);
    assert(found.some(f => wanted.test(f)), `no fault like ${wanted} among [${found}]`);
    count++;
}
const pod = of => of("StatefulSet").spec.template.spec;

await finds(/StatefulSet.*additional properties replica$/, of => { of("StatefulSet").spec.replica = 1; });
await finds(/livenessProbe.*additional properties grcp/, of => { pod(of).containers[0].livenessProbe.grcp = { port: 1 }; });
await finds(/required property 'selector'/, of => { delete of("StatefulSet").spec.selector; });
await finds(/replicas must be integer/, of => { of("StatefulSet").spec.replicas = "1"; });
await finds(/knows no apps\/v1 StatefullSet/, of => { of("StatefulSet").kind = "StatefullSet"; });
await finds(/there is no StatefulSet/, (of, all) => { all.splice(all.indexOf(of("StatefulSet")), 1); });
await finds(/there is no NetworkPolicy/, (of, all) => { all.splice(all.indexOf(of("NetworkPolicy")), 1); });
await finds(/PodDisruptionBudget.*selects no pod/, of => { of("PodDisruptionBudget").spec.selector.matchLabels = { app: "other" }; });
await finds(/PodDisruptionBudget.*selects no pod/, of => { delete of("PodDisruptionBudget").spec.selector; });
await finds(/Service jostle: no container has a port web/, of => { of("Service").spec.ports[0].targetPort = "web"; });
await finds(/no volume settings/, of => { pod(of).volumes = pod(of).volumes.filter(v => v.name !== "settings"); });
await finds(/no ServiceAccount/, of => { of("ServiceAccount").metadata.name = "other"; });
await finds(/no headless Service/, of => { of("StatefulSet").spec.serviceName = "jostle"; });
await finds(/less than drain_timeout_seconds/, of => { pod(of).terminationGracePeriodSeconds = 20; });
await finds(/is_running as root/, of => { pod(of).securityContext.runAsUser = 0; });
await finds(/root can be written to/, of => { pod(of).containers[0].securityContext.readOnlyRootFilesystem = false; });
await finds(/keeps capabilities/, of => { pod(of).containers[0].securityContext.capabilities = { add: ["NET_ADMIN"] }; });
await finds(/allowPrivilegeEscalation/, of => { delete pod(of).containers[0].securityContext.allowPrivilegeEscalation; });
await finds(/folder of its node/, of => { pod(of).volumes.push({ name: "root", hostPath: { path: "/" } }); });
await finds(/gets a token/, of => { delete pod(of).automountServiceAccountToken; });
await finds(/no limit of memory/, of => { delete pod(of).containers[0].resources.limits; });
await finds(/no tag/, of => { pod(of).containers[0].image = "jostle-server:latest"; });
await finds(/no readinessProbe/, of => { delete pod(of).containers[0].readinessProbe; });

function finds_in_compose(wanted, spoil) {
    const copy = structuredClone(composed);
    spoil(copy.services.server, copy);
    const found = compose.faults(copy, path.dirname(compose_file));
    assert(found.some(f => wanted.test(f)), `no fault like ${wanted} among [${found}]`);
    count++;
}
finds_in_compose(/additional properties readonly/, s => { s.readonly = true; });
finds_in_compose(/root can be written to/, s => { s.read_only = false; });
finds_in_compose(/keeps capabilities/, s => { s.cap_drop = ["NET_RAW"]; });
finds_in_compose(/may gain privileges/, s => { delete s.security_opt; });
finds_in_compose(/names no user, or root/, s => { s.user = "0:0"; });
finds_in_compose(/no bound of memory/, s => { delete s.mem_limit; });
finds_in_compose(/beyond loopback/, s => { s.ports = ["8080:8080"]; });
finds_in_compose(/one that moves/, s => { s.image = "jostle-server"; });
finds_in_compose(/is not there/, s => { s.volumes = ["./no_such.toml:/etc/x:ro"]; });
finds_in_compose(/can be written to/, s => { s.volumes = ["./compose-server.toml:/etc/x"]; });
finds_in_compose(/shares the machine/, s => { s.network_mode = "host"; });

console.log(`self test: ${count} faults put in, ${count} found`);
