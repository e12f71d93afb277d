// Tests the checks of this folder: puts one fault at a time into valid files; the check must name
// it.
//
// Usage: node self_test.mjs MANIFESTS COMPOSE_FILE    (MANIFESTS: output of `kubectl kustomize`)
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import * as compose from "./check_compose.mjs";
import * as manifests from "./check_manifests.mjs";

const [, , manifest_file, compose_file] = process.argv;
const objects = manifests.parse(readFileSync(manifest_file, "utf8"));
const composed = compose.parse(readFileSync(compose_file, "utf8"));
let count = 0;

// Each `spoil` function changes a copy of the objects; one of the faults must match `expected`.
async function finds(expected, spoil) {
    const copy = structuredClone(objects);
    spoil(kind => copy.find(o => o.kind === kind), copy);
    const found = await manifests.faults(copy);
    assert(found.some(f => expected.test(f)), `no fault matches ${expected} among [${found}]`);
    count++;
}
const pod = of => of("StatefulSet").spec.template.spec;

await finds(/StatefulSet.*additional properties replica$/, of => { of("StatefulSet").spec.replica = 1; });
await finds(/livenessProbe.*additional properties grcp/, of => { pod(of).containers[0].livenessProbe.grcp = { port: 1 }; });
await finds(/required property 'selector'/, of => { delete of("StatefulSet").spec.selector; });
await finds(/replicas must be integer/, of => { of("StatefulSet").spec.replicas = "1"; });
await finds(/unknown kind apps\/v1 StatefullSet/, of => { of("StatefulSet").kind = "StatefullSet"; });
await finds(/StatefulSet is missing/, (of, all) => { all.splice(all.indexOf(of("StatefulSet")), 1); });
await finds(/NetworkPolicy is missing/, (of, all) => { all.splice(all.indexOf(of("NetworkPolicy")), 1); });
await finds(/PodDisruptionBudget.*matches no pod/, of => { of("PodDisruptionBudget").spec.selector.matchLabels = { app: "other" }; });
await finds(/PodDisruptionBudget.*matches no pod/, of => { delete of("PodDisruptionBudget").spec.selector; });
await finds(/Service jostle: no container has a port web/, of => { of("Service").spec.ports[0].targetPort = "web"; });
await finds(/no volume settings/, of => { pod(of).volumes = pod(of).volumes.filter(v => v.name !== "settings"); });
await finds(/no ServiceAccount/, of => { of("ServiceAccount").metadata.name = "other"; });
await finds(/no headless Service/, of => { of("StatefulSet").spec.serviceName = "jostle"; });
await finds(/less than drain_timeout_seconds/, of => { pod(of).terminationGracePeriodSeconds = 20; });
await finds(/runs as root/, of => { pod(of).securityContext.runAsUser = 0; });
await finds(/root file system is writable/, of => { pod(of).containers[0].securityContext.readOnlyRootFilesystem = false; });
await finds(/capabilities are not dropped/, of => { pod(of).containers[0].securityContext.capabilities = { add: ["NET_ADMIN"] }; });
await finds(/allowPrivilegeEscalation/, of => { delete pod(of).containers[0].securityContext.allowPrivilegeEscalation; });
await finds(/is a hostPath/, of => { pod(of).volumes.push({ name: "root", hostPath: { path: "/" } }); });
await finds(/automountServiceAccountToken/, of => { delete pod(of).automountServiceAccountToken; });
await finds(/no memory limit/, of => { delete pod(of).containers[0].resources.limits; });
await finds(/no fixed tag/, of => { pod(of).containers[0].image = "jostle-server:latest"; });
await finds(/not on a volume of volumeClaimTemplates/, of => { of("StatefulSet").spec.volumeClaimTemplates[0].metadata.name = "worlds2"; pod(of).volumes.push({ name: "worlds", emptyDir: {} }); });
await finds(/no UDP port in the container/, of => { pod(of).containers[0].ports.find(p => p.name === "datagrams").protocol = "TCP"; });
await finds(/no UDP port in a Service/, (of, all) => { for (const s of all.filter(o => o.kind === "Service")) s.spec.ports = s.spec.ports.filter(p => p.name !== "datagrams"); });
await finds(/does not admit datagrams/, of => { of("NetworkPolicy").spec.ingress[0].ports.pop(); });
await finds(/no readinessProbe/, of => { delete pod(of).containers[0].readinessProbe; });

function finds_in_compose(expected, spoil) {
    const copy = structuredClone(composed);
    spoil(copy.services.server, copy);
    const found = compose.faults(copy, path.dirname(compose_file));
    assert(found.some(f => expected.test(f)), `no fault matches ${expected} among [${found}]`);
    count++;
}
finds_in_compose(/additional properties readonly/, s => { s.readonly = true; });
finds_in_compose(/not on a named volume/, s => { s.volumes = s.volumes.filter(v => !v.startsWith("worlds")); });
finds_in_compose(/UDP port of datagrams.listen is not published/, s => { s.ports = s.ports.filter(p => !p.endsWith("/udp")); });
finds_in_compose(/root file system is writable/, s => { s.read_only = false; });
finds_in_compose(/capabilities are not dropped/, s => { s.cap_drop = ["NET_RAW"]; });
finds_in_compose(/no-new-privileges/, s => { delete s.security_opt; });
finds_in_compose(/user is missing or root/, s => { s.user = "0:0"; });
finds_in_compose(/mem_limit/, s => { delete s.mem_limit; });
finds_in_compose(/beyond loopback/, s => { s.ports = ["8080:8080"]; });
finds_in_compose(/no fixed tag/, s => { s.image = "jostle-server"; });
finds_in_compose(/does not exist/, s => { s.volumes = ["./no_such.toml:/etc/x:ro"]; });
finds_in_compose(/mounted writable/, s => { s.volumes = ["./compose-server.toml:/etc/x"]; });
finds_in_compose(/shares a namespace/, s => { s.network_mode = "host"; });

console.log(`self test: ${count} faults inserted, ${count} detected`);
