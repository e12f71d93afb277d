import { PlayerRole } from '@jostle/client/gen/play_pb';
import { expect, it } from 'vitest';
import { describePlayer, sortPlayers, type ListedPlayer } from './players_panel';

const player = (client: number, name: string, change: Partial<ListedPlayer> = {}): ListedPlayer => ({
  client, name, color: 0, role: PlayerRole.PLAYER, pingMs: 0, disconnected: false, own: false, hidden: false, followed: false, ...change,
});

it('lists the user first, then by role and name', () => {
  const players = [player(1, 'c'), player(2, 'b', { role: PlayerRole.OWNER }), player(3, 'a'), player(4, 'z', { own: true })];
  expect(sortPlayers(players).map(({ client }) => client)).toEqual([4, 2, 3, 1]);
});

it('describes role, ping and state', () => {
  expect(describePlayer(player(1, 'a', { own: true, pingMs: 12 }), true)).toBe('you · player · 12 ms');
  expect(describePlayer(player(1, 'a', { disconnected: true, pingMs: 12, hidden: true }), false)).toBe('connection lost · muted');
});
