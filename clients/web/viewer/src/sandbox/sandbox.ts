// The sandbox tools: selection, inspector, plots, time, options of spawned bodies and joints, and undo.
// Panels are loaded when they are opened.

import type { Connection, Queries } from '@jostle/client';
import { PlayerRole, type InputResult, type WorldStats } from '@jostle/client/gen/play_pb';
import type { InspectResponse } from '@jostle/client/gen/query_pb';
import type * as THREE from 'three';
import type { Pick } from '../interaction/pick';
import { Throttle } from '../interaction/throttle';
import { entityName } from '../panels/entity_names';
import type { Room } from '../room/room';
import type { SceneView } from '../scene/scene_view';
import type { Commands } from '../ui/commands';
import type { MenuItem } from '../ui/context_menu';
import type { Panels } from '../ui/panels';
import { defaultJointOptions } from './joint_options';
import { JointTool } from './joint_tool';
import { pickJoint } from './pick_joint';
import type { InspectorPanel } from './inspector_panel';
import type { PlotsPanel } from './plots_panel';
import { SandboxCommands } from './sandbox_commands';
import { Selection } from './selection';
import { SelectionView } from './selection_view';
import { defaultSpawnOptions } from './spawn_options';
import type { TimePanel } from './time_panel';

const QUERY_INTERVAL_MS = 200; // of the inspected body or joint
const CLONE_OFFSET = { x: 0, y: 1.5, z: 0 }; // m

export interface SandboxOptions {
  readonly connection: Connection;
  readonly queries: Queries;
  readonly view: SceneView;
  readonly panels: Panels;
  readonly commands: Commands;
  /** Shows what the user does next; empty: nothing. */
  readonly hint: HTMLElement;
  isPlanar(): boolean;
  focus(entity: number): void;
  stats(): WorldStats | undefined;
  readonly room: Room;
}

export class Sandbox {
  readonly spawnOptions = defaultSpawnOptions();
  readonly jointOptions = defaultJointOptions();
  readonly selection = new Selection();
  readonly selectionView: SelectionView;
  readonly commands = new SandboxCommands((kind) => this.options.connection.send({ kind }));
  readonly jointTool: JointTool;
  private inspectorPanel: InspectorPanel | undefined;
  private readonly throttle = new Throttle(QUERY_INTERVAL_MS, () => this.query());
  private timePanel: TimePanel | undefined;
  private plotsPanel: PlotsPanel | undefined;
  private inspected: InspectResponse | undefined;

  constructor(private readonly options: SandboxOptions) {
    const { connection, view, hint } = options;
    this.selectionView = new SelectionView(view.scene);
    this.jointTool = new JointTool({
      options: this.jointOptions,
      poseOf: (entity) => view.poseOf(entity),
      isDynamic: (entity) => (connection.entities.get(entity)?.mass ?? 0) > 0,
      nameOf: (entity) => this.nameOf(entity),
      isPlanar: options.isPlanar,
      send: (kind) => connection.send({ kind }),
      onHint: (text) => {
        hint.textContent = text;
        hint.hidden = text === '';
      },
    });
  }

  /** Registers the panels and the keys. */
  register(): void {
    this.registerPanels();
    this.registerCommands();
    this.selection.onChange(() => this.setInspected(undefined));
  }

  /** What the inspector received last; undefined: nothing is inspected. */
  get newestInspection(): InspectResponse | undefined {
    return this.inspected;
  }

  private nameOf(entity: number): string {
    return entityName(this.options.connection.entities.get(entity), entity);
  }

  private clientName(client: number): string {
    const { data, welcome } = this.options.connection;
    if (client === welcome?.clientId) return 'you';
    return data.players.get(client)?.name || `client ${client}`;
  }

  /** The rule for attributes of entities, which rooms cannot change. Empty: the client may change them. */
  private attributeRefusal(entity: number): string {
    const { data, welcome, entities } = this.options.connection;
    const role = data.players.get(welcome?.clientId ?? 0)?.role ?? PlayerRole.SPECTATOR;
    if (role >= PlayerRole.BUILDER) return '';
    if (role === PlayerRole.SPECTATOR) return 'Spectators cannot change attributes of entities.';
    return entities.get(entity)?.owner === welcome?.clientId ? '' : 'Players can change attributes of entities that they own.';
  }

  /** Players, attributes or the room changed. */
  onDataChanged(): void {
    this.inspectorPanel?.showRights();
  }

  /** Returns whether a panel shows the refusal of the input. */
  rejected(result: InputResult): boolean {
    return this.inspectorPanel?.rejected(result) ?? false;
  }

  private registerPanels(): void {
    const { panels, connection, view } = this.options;
    panels.register({
      id: 'inspector',
      title: 'Inspector',
      hint: 'State of the selected body or joint',
      key: 'o',
      icon: 'inspect',
      side: 'right',
      compact: true,
      load: async (content) => {
        const { InspectorPanel } = await import('./inspector_panel');
        this.inspectorPanel = new InspectorPanel(content, {
          connection,
          selection: this.selection,
          commands: this.commands,
          names: { ofEntity: (id) => this.nameOf(id), ofClient: (id) => this.clientName(id) },
          poseOf: (entity) => view.poseOf(entity),
          focus: this.options.focus,
          refusal: (action, entity) => this.options.room.rules.refusal(action, this.options.room.ownerOf(entity)),
          jointRefusal: () => this.options.room.rules.refusal('joints'),
          attributeRefusal: (entity) => this.attributeRefusal(entity),
        });
        return {};
      },
    });
    panels.register({
      id: 'plots',
      title: 'Plots',
      hint: 'Motion and forces of the selection over time',
      key: 'g',
      icon: 'plot',
      side: 'right',
      compact: true,
      load: async (content) => {
        const { PlotsPanel } = await import('./plots_panel');
        const plots = new PlotsPanel(content, { connection, save: saveText });
        this.plotsPanel = plots;
        plots.select(this.selection.current);
        this.selection.onChange((selected) => plots.select(selected));
        // The statistics would leave both panels too little height.
        return { opened: () => panels.close('stats'), update: () => plots.update() };
      },
    });
    panels.register({
      id: 'time',
      title: 'Time',
      hint: 'Pause, single step, slow motion, timeline and reset',
      key: 'y',
      icon: 'time',
      side: 'left',
      compact: true,
      load: async (content) => {
        const { TimePanel } = await import('./time_panel');
        this.timePanel = new TimePanel(content, { commands: this.commands, refusal: (action) => this.options.room.rules.refusal(action), tickHz: () => connection.welcome?.tickHz || 60 });
        this.timePanel.update(this.options.stats());
        return {};
      },
    });
    panels.register({
      id: 'build',
      title: 'Build',
      hint: 'Size, mass, material and color of new bodies, and the kind of new joints',
      key: 'b',
      icon: 'build',
      side: 'left',
      compact: true,
      load: async (content) => {
        const { BuildPanel } = await import('./build_panel');
        return new BuildPanel(content, this.spawnOptions, this.jointOptions, () => this.jointTool.updateHint()) as object;
      },
    });
  }

  private registerCommands(): void {
    const { commands } = this.options;
    const forBody = (run: (body: number) => void) => () => this.selection.body !== 0 && run(this.selection.body);
    commands.register({ key: 'k', label: 'Pause or resume the world', run: () => this.commands.setPaused(!this.options.stats()?.paused) });
    commands.register({ key: '.', label: 'Simulate one step of the paused world', run: () => this.commands.step() });
    commands.register({ key: 'z', label: 'Undo your newest action', run: () => this.commands.undo() });
    commands.register({ key: 'x', label: 'Freeze or unfreeze the selected body', run: forBody((body) => this.commands.setFrozen(body, !this.inspected?.body?.frozen)) });
    commands.register({ key: 'v', label: 'Clone the selected body', run: forBody((body) => this.commands.clone(body, CLONE_OFFSET, false)) });
  }

  /** Some open panel shows the state of the selection. */
  private get isInspecting(): boolean {
    const { panels } = this.options;
    return this.selection.current !== undefined && (panels.isOpen('inspector') || panels.isOpen('plots'));
  }

  private async query(): Promise<void> {
    const { current } = this.selection;
    if (!current) return;
    const response = await this.options.queries.inspect(current.kind === 'body' ? { entity: current.id } : { joint: current.id });
    // The selection or the panels may have changed during the query.
    if (this.selection.current === current) this.setInspected(this.isInspecting ? response : undefined);
  }

  private setInspected(response: InspectResponse | undefined): void {
    this.inspected = response;
    this.inspectorPanel?.show(response);
    this.selectionView.setInspected(response);
    if (response) this.plotsPanel?.addInspection(response);
  }

  /** Items of the menu of a body. */
  menuItems(entity: number, enabled: boolean): MenuItem[] {
    const isDynamic = (this.options.connection.entities.get(entity)?.mass ?? 0) > 0;
    const isStill = this.selection.body === entity && (this.inspected?.body?.frozen ?? false);
    const { room } = this.options;
    const [editing, cloning] = (['edit', 'clone'] as const).map((action) => room.rules.refusal(action, room.ownerOf(entity)));
    return [
      { label: 'Inspect', run: () => this.inspect(entity) },
      ...(enabled && (isDynamic || isStill) ? [{ label: isStill ? 'Unfreeze' : 'Freeze', refusal: editing!, run: () => this.commands.setFrozen(entity, !isStill) }] : []),
      ...(enabled && isDynamic ? [{ label: 'Clone', refusal: cloning!, run: () => this.commands.clone(entity, CLONE_OFFSET, false) }] : []),
      ...(enabled && isDynamic ? [{ label: 'Clone with joints', refusal: cloning!, run: () => this.commands.clone(entity, CLONE_OFFSET, true) }] : []),
    ];
  }

  private inspect(entity: number): void {
    this.selection.select({ kind: 'body', id: entity });
    this.options.panels.open('inspector');
  }

  /** A click of the tool Inspect: a joint close to the pointer, or else the body under it. */
  inspectAt(hit: Pick | undefined, ray: THREE.Ray): void {
    const joint = pickJoint(this.options.connection.joints.joints, ray, (entity) => this.options.view.poseOf(entity));
    if (joint !== undefined) this.selection.select({ kind: 'joint', id: joint });
    else this.selection.select(hit && hit.entity !== 0 ? { kind: 'body', id: hit.entity } : undefined);
    this.options.panels.open('inspector');
  }

  onStats(stats: WorldStats): void {
    this.timePanel?.update(stats);
    this.plotsPanel?.addStats(stats);
  }

  /** Entities or joints were added or removed. */
  onWorldChanged(): void {
    const { entities, joints } = this.options.connection;
    this.selection.retain((id) => entities.has(id), (id) => joints.joints.has(id));
  }

  /** Returns whether there was something to cancel. */
  cancel(): boolean {
    if (this.jointTool.cancel()) return true;
    const selected = this.selection.current !== undefined;
    this.selection.select(undefined);
    return selected;
  }

  /** Call once per rendered frame, after the bodies were updated. */
  update(): void {
    const { view, connection } = this.options;
    if (this.isInspecting) this.throttle.request();
    else if (this.inspected) this.setInspected(undefined);
    this.selectionView.update(this.selection.current, view, connection.joints.joints, connection.welcome?.tickHz || 60, this.jointTool.start);
  }
}

function saveText(name: string, text: string): void {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/csv' }));
  Object.assign(document.createElement('a'), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}
