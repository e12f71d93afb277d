// The monitor page: worlds, clients, traffic, refusals and the log of a server, with the commands of an
// administrator. It polls GetServerStatus once per second.

import { AdminApi, CallError, type Ban, type ClientInfo, type LogLine, type Report, type Room, type RoomMember, type ServerStatus, type WorldInfo } from './api';
import { element } from '../ui/elements';
import { button, isInUse, showTable } from './dom';
import { duration, Rates, shortNumber, type Rate } from './rates';
import './style.css';

const POLL_MS = 1000;
const LOG_LINES_MAX = 500;
const TOKEN_KEY = 'jostle-admin-token';

function find<E extends HTMLElement = HTMLElement>(id: string): E {
  return document.getElementById(id) as E;
}

const api = new AdminApi();
const traffic = new Rates();
const inputs = new Rates();
const refusals = new Rates();
let lastLine = '0';
let uptime = 0;
let roomOf = ''; // id of the world whose room is shown

// --- commands ---

function showFault(error: unknown): void {
  const fault = find('fault');
  fault.textContent = error instanceof Error ? error.message : String(error);
  fault.hidden = false;
  if (error instanceof CallError && error.signIn) find('sign-in').hidden = false;
}

async function run(method: string, request: object): Promise<void> {
  try {
    await api.call(method, request);
    find('fault').hidden = true;
    await poll();
  } catch (error) {
    showFault(error);
  }
}

/** Asks for a reason first; the user can cancel. */
function withReason(question: string, action: (reason: string) => void): void {
  const reason = window.prompt(`${question}\nReason, sent to the client:`, '');
  if (reason !== null) action(reason);
}

// --- sections ---

function showServer(status: ServerStatus): void {
  const rate = status.clients.reduce((sum, client) => sum + client.kbitPerSecond, 0);
  find('server').textContent = [
    `version ${status.version}`,
    `up ${duration(status.uptimeSeconds)}`,
    `${status.worlds.length} worlds`,
    `${status.clients.length} clients`,
    `${shortNumber(rate * 1000)}bit/s`,
    status.draining ? 'draining' : '',
  ]
    .filter(Boolean)
    .join(', ');
}

function roomText({ room }: WorldInfo): string {
  if (!room) return '-';
  return [room.title || 'untitled', room.isPrivate ? 'private' : '', room.unlisted ? 'unlisted' : ''].filter(Boolean).join(', ');
}

function showWorlds(worlds: readonly WorldInfo[]): void {
  showTable(
    find('worlds'),
    [
      { title: 'id', cell: (world) => world.id },
      { title: 'name', cell: (world) => world.name },
      { title: 'scene', cell: (world) => world.scene },
      { title: 'room', cell: roomText },
      { title: 'owner', cell: (world) => world.owner || '-' },
      { title: 'clients', cell: (world) => `${world.clients}${world.room?.capacity ? `/${world.room.capacity}` : ''}`, isNumber: true },
      { title: 'bodies', cell: (world) => String(world.bodies), isNumber: true },
      { title: 'awake', cell: (world) => String(world.awake), isNumber: true },
      { title: 'tick ms', cell: (world) => world.stepMsMean.toFixed(2), isNumber: true },
      { title: 'time scale', cell: (world) => world.timeScale.toFixed(2), isNumber: true },
      { title: 'state', cell: (world) => (world.paused ? `paused: ${world.paused}` : 'runs') },
      {
        title: '',
        cell: (world) => [
          button(world.paused ? 'Resume' : 'Pause', () => void run('SetPaused', { world: world.id, paused: !world.paused })),
          ...(world.room ? [button('Room', () => void openRoom(world.id))] : []),
        ],
      },
    ],
    worlds,
    'The server has no worlds.',
  );
}

function showClients(clients: readonly ClientInfo[]): void {
  showTable(
    find('clients'),
    [
      { title: 'id', cell: (client) => String(client.id), isNumber: true },
      { title: 'name', cell: (client) => client.name + (client.spectator ? ' (spectator)' : '') },
      { title: 'subject', cell: (client) => client.subject || '-' },
      { title: 'world', cell: (client) => client.worldName },
      { title: 'address', cell: (client) => client.address },
      { title: 'connected', cell: (client) => duration(client.connectedSeconds), isNumber: true },
      { title: 'kbit/s', cell: (client) => client.kbitPerSecond.toFixed(1), isNumber: true },
      { title: 'skipped', cell: (client) => String(client.snapshotsSkipped), isNumber: true },
      { title: 'round trip ms', cell: (client) => client.roundTripMs.toFixed(1), isNumber: true },
      { title: '', cell: clientButtons },
    ],
    clients,
    'No clients are connected.',
  );
}

function clientButtons(client: ClientInfo): HTMLButtonElement[] {
  const kick = () => withReason(`Disconnect client ${client.id}?`, (reason) => void run('Kick', { client: client.id, reason }));
  const ban = () => withReason(`Ban ${client.subject}?`, (reason) => void run('Ban', { subject: client.subject, reason }));
  const buttons = [button('Kick', kick)];
  if (client.subject && client.subject !== 'anonymous') buttons.push(button('Ban', ban));
  buttons.push(button('Remove bodies', () => void run('RemoveBodies', { world: client.world, client: client.id })));
  return buttons;
}

function showCounters(status: ServerStatus): void {
  const seconds = performance.now() / 1000;
  const rows = [
    ...traffic.read(status.sentBytes, seconds).map((rate) => ({ group: 'sent bytes', rate })),
    ...inputs.read(status.inputs, seconds).map((rate) => ({ group: 'inputs', rate })),
    ...refusals.read(status.refusals, seconds).map((rate) => ({ group: 'refused streams and calls', rate })),
  ].filter(({ group, rate }) => group !== 'refused streams and calls' || rate.total > 0);
  showTable<{ group: string; rate: Rate }>(
    find('counters'),
    [
      { title: 'counter', cell: ({ group }) => group },
      { title: 'kind', cell: ({ rate }) => rate.name },
      { title: 'per second', cell: ({ rate }) => shortNumber(rate.perSecond), isNumber: true },
      { title: 'total', cell: ({ rate }) => shortNumber(rate.total), isNumber: true },
    ],
    rows,
    'The token is limited to certain worlds, so it has no counters of the server.',
  );
}

function showLog(lines: readonly LogLine[]): void {
  const log = find('log');
  for (const line of lines) {
    const item = element('li', `${line.time} ${line.level} ${line.text}`, line.level);
    log.prepend(item);
    lastLine = line.number;
  }
  while (log.childElementCount > LOG_LINES_MAX) log.lastElementChild?.remove();
}

function showReports(reports: readonly Report[]): void {
  const nameOf = (client: number, name: string) => (client === 0 ? '-' : `${client} ${name}`);
  showTable(
    find('reports'),
    [
      { title: 'time', cell: (report) => report.time },
      { title: 'world', cell: (report) => report.worldName },
      { title: 'tick', cell: (report) => String(report.tick), isNumber: true },
      { title: 'from', cell: (report) => nameOf(report.from, report.fromName) },
      { title: 'about', cell: (report) => nameOf(report.client, report.name) },
      { title: 'reason', cell: (report) => report.reason },
      { title: 'messages', cell: (report) => report.messages.map((message) => `"${message}"`).join(' ') || '-' },
    ],
    [...reports].sort((a, b) => b.time.localeCompare(a.time)),
    'Players reported no others.',
  );
}

function showBans(bans: readonly Ban[]): void {
  showTable(
    find('bans'),
    [
      { title: 'subject or network', cell: (ban) => ban.subject || ban.network },
      { title: 'reason', cell: (ban) => ban.reason || '-' },
      { title: 'by', cell: (ban) => ban.by },
      { title: 'until', cell: (ban) => ban.expires || 'it is removed' },
      { title: '', cell: (ban) => button('Unban', () => void run('Unban', ban.subject ? { subject: ban.subject } : { network: ban.network })) },
    ],
    bans,
    'There are no bans.',
  );
}

// --- the room of one world ---

const ROLES = ['SPECTATOR', 'PLAYER', 'BUILDER', 'OWNER'].map((role) => `PLAYER_ROLE_${role}`);

function moderate(command: object): void {
  void run('ModerateRoom', { world: roomOf, command });
}

function roleChoice(member: RoomMember): HTMLSelectElement {
  const choice = element('select');
  for (const role of ROLES) {
    const option = element('option', role.replace('PLAYER_ROLE_', '').toLowerCase());
    option.value = role;
    option.selected = role === member.role;
    choice.append(option);
  }
  choice.addEventListener('change', () => {
    choice.blur();
    moderate({ setRole: { client: member.client, role: choice.value } });
  });
  return choice;
}

function showRoom(room: Room): void {
  find('room-section').hidden = false;
  find('room-title').textContent = `Room of ${roomOf}: ${room.settings.title || 'untitled'}, owner ${room.owner || 'the longest present player'}`;
  const members = element('div');
  showTable(
    members,
    [
      { title: 'client', cell: (member) => String(member.client), isNumber: true },
      { title: 'role', cell: roleChoice },
      { title: 'member', cell: (member) => member.member },
      { title: 'state', cell: (member) => (member.removed ? 'removed' : member.muted ? 'muted' : '-') },
      {
        title: '',
        cell: ({ client, muted }) => [
          button(muted ? 'Unmute' : 'Mute 5 min', () => moderate({ mute: { client, seconds: muted ? 0 : 300 } })),
          button('Clean up', () => moderate({ cleanUp: { client } })),
          button('Kick', () => withReason(`Remove client ${client} from the room?`, (reason) => moderate({ kick: { client, reason } }))),
          button('Ban 1 h', () => withReason(`Ban client ${client} from the room?`, (reason) => moderate({ ban: { client, seconds: 3600, reason } }))),
        ],
      },
    ],
    room.members,
    'The room has no clients.',
  );
  const rules = element('div');
  for (const area of room.settings.areas) rules.append(element('p', `area ${area.name}, for the role ${area.minRole} `), button('Unprotect', () => moderate({ unprotect: { name: area.name } })));
  for (const ban of room.bans) rules.append(element('p', `ban of ${ban.member}${ban.permanent ? '' : ', for a time'} ${ban.reason}`), button('Unban', () => moderate({ unban: { member: ban.member } })));
  if (room.voteTarget) rules.append(element('p', `vote to kick client ${room.voteTarget}: ${room.votes} votes`));
  const actions = element('p');
  actions.append(
    button('Reset', () => {
      if (window.confirm('Start the world from its scene again?')) moderate({ reset: {} });
    }),
    button('Close', () => {
      roomOf = '';
      find('room-section').hidden = true;
    }),
  );
  if (!isInUse(find('room'))) find('room').replaceChildren(members, rules, actions);
}

async function openRoom(world: string): Promise<void> {
  roomOf = world;
  await poll();
}

// --- polling ---

async function poll(): Promise<void> {
  try {
    const status = await api.call<ServerStatus>('GetServerStatus', { logAfter: lastLine });
    if (status.uptimeSeconds < uptime) {
      lastLine = '0'; // another process has its own numbers
      find('log').replaceChildren();
    }
    uptime = status.uptimeSeconds;
    find('sign-in').hidden = true;
    showServer(status);
    showWorlds(status.worlds);
    showClients(status.clients);
    showCounters(status);
    showLog(status.log);
    showBans(status.bans);
    showReports(status.reports);
    if (roomOf) showRoom(await api.call<Room>('GetRoom', { world: roomOf }));
  } catch (error) {
    showFault(error);
  }
}

async function pollForever(): Promise<void> {
  for (;;) {
    if (!document.hidden) await poll();
    await new Promise((resolve) => setTimeout(resolve, POLL_MS));
  }
}

find<HTMLFormElement>('sign-in').addEventListener('submit', (event) => {
  event.preventDefault();
  api.token = find<HTMLInputElement>('token').value.trim();
  sessionStorage.setItem(TOKEN_KEY, api.token);
  find('fault').hidden = true;
  void poll();
});
find('drain').addEventListener('click', () => {
  if (window.confirm('Drain the server: notify all clients, then exit?')) void run('Drain', {});
});
find<HTMLSelectElement>('level').addEventListener('change', (event) => {
  find('log').dataset['level'] = (event.target as HTMLSelectElement).value;
});

api.token = sessionStorage.getItem(TOKEN_KEY) ?? '';
void pollForever();
