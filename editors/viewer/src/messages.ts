// What the viewer and its host say to each other. docs/preview.md describes it in words.

export interface Position {
  line: number;
  character: number;
}

/** A place in a file, as the language server protocol writes it. */
export interface Location {
  uri: string;
  range: { start: Position; end: Position };
}

/** Meters, and radians about fixed axes. */
export interface Pose {
  xyz: [number, number, number];
  rpy: [number, number, number];
}

export type Shape =
  | { kind: 'box'; size: [number, number, number] }
  | { kind: 'cylinder'; radius: number; length: number }
  /** `length` is that of the cylinder, without the half spheres. */
  | { kind: 'capsule'; radius: number; length: number }
  | { kind: 'sphere'; radius: number }
  /** `mesh` is the id of an entry of `Model.meshes`; without it `problem` says why there is none. */
  | { kind: 'mesh'; uri: string; scale: [number, number, number]; mesh?: string; problem?: string }
  | { kind: 'unknown'; problem: string };

export interface Body {
  name?: string;
  pose: Pose;
  shape: Shape;
  /** Red, green, blue, opacity: 0 to 1. */
  color?: [number, number, number, number];
  /** Id of a picture in `Model.meshes`. */
  texture?: string;
  origin?: Location;
}

export interface Inertial {
  pose: Pose;
  /** kg */
  mass: number;
  /** ixx ixy ixz iyy iyz izz about the center of mass, kg m^2. */
  inertia?: [number, number, number, number, number, number];
}

export interface Link {
  name: string;
  inertial?: Inertial;
  visuals: Body[];
  collisions: Body[];
  /** The element that made it. */
  origin?: Location;
  /** The outermost macro call that led there. */
  call?: Location;
}

export type JointType = 'revolute' | 'continuous' | 'prismatic' | 'fixed' | 'floating' | 'planar';

export interface Joint {
  name: string;
  type: JointType;
  parent: string;
  child: string;
  pose: Pose;
  /** In the joint's frame; not always of unit length. */
  axis: [number, number, number];
  /** Radians or meters. */
  limit?: { lower: number; upper: number; effort?: number; velocity?: number };
  mimic?: { joint: string; multiplier: number; offset: number };
  origin?: Location;
  call?: Location;
}

export interface MeshFile {
  /** File name, for messages. */
  name: string;
  /** Lower case ending. */
  format: string;
  bytes: number;
  /** Corners of the box around it in the file's units, where the server knows it. */
  box?: [[number, number, number], [number, number, number]];
  /** Files it names, by the name it gives them: ids of further entries. */
  files?: Record<string, string>;
}

export interface Model {
  robot: string;
  links: Link[];
  joints: Joint[];
  /** Files by opaque id. An id stands for one content: a changed file gets another id. */
  meshes: Record<string, MeshFile>;
}

export interface Root {
  uri: string;
  args?: Record<string, string>;
  preset?: string;
}

export interface ModelError {
  message: string;
  code: string;
  location: Location;
}

/** Something in the robot that a program which reads URDF rejects, changes or ignores. */
export interface Construct {
  title: string;
  /** What to write instead. */
  help?: string;
  /** Titles of programs. */
  rejected: string[];
  changed: string[];
  /** How many places have it; the first ones are in `places`. */
  count: number;
  places: { of: string; location: Location }[];
}

export interface Programs {
  /** Titles of the programs that were asked for. */
  names: string[];
  constructs: Construct[];
}

export type Side = 'main' | 'compare';

/** The parameters of `xacro/preview/model`. */
export interface ModelMessage {
  type: 'model';
  id: number;
  side: Side;
  /** Grows with every message of a subscription, of both sides together. */
  revision: number;
  ok: boolean;
  /** Absent when the text is broken and `lastGood` is there. */
  model?: Model;
  errors: ModelError[];
  lastGood?: Model;
  /** The revision `lastGood` was sent with. */
  goodRevision?: number;
  root: Root;
  /** Arguments of the root with their values. */
  args: { name: string; value: string }[];
  /** Roots and presets to choose from. */
  choices: Root[];
  /** Absent when the text has errors: no program is given the robot. */
  programs?: Programs;
}

/** The parameters of `xacro/preview/select` from the server. */
export interface SelectMessage {
  type: 'select';
  id?: number;
  link?: string;
  joint?: string;
  links?: string[];
  joints?: string[];
  location?: Location;
}

/** The answer to a `mesh` of the viewer. `data` may be text in base64. */
export interface MeshMessage {
  type: 'mesh';
  mesh: string;
  data?: ArrayBuffer | Uint8Array | string;
  error?: string;
}

/** The answer to a `urdf` of the viewer. */
export interface UrdfMessage {
  type: 'urdf';
  text?: string;
  error?: string;
}

export interface SettingsMessage {
  type: 'settings';
  /** Whether the host answers `urdf`. */
  urdf?: boolean;
  /** Pictures a second, at most. */
  fps?: number;
  /** Larger meshes are shown as boxes. */
  meshMaxMB?: number;
  theme?: 'light' | 'dark';
}

/** The compare side is no longer there. */
export interface ClosedMessage {
  type: 'closed';
  side: Side;
}

export type FromHost = ModelMessage | SelectMessage | MeshMessage | UrdfMessage | SettingsMessage | ClosedMessage;

export type ToHost =
  /** The viewer listens: send it everything there is. */
  | { type: 'ready' }
  /** The user clicked something: show `location` in the editor. */
  | { type: 'select'; link?: string; joint?: string; location?: Location }
  /** An entry of the list of errors was clicked. */
  | { type: 'open'; location: Location }
  /** Another root or other arguments were chosen; `compare` is shown beside it, null: nothing. */
  | { type: 'root'; root: Root; compare: Root | null }
  /** The bytes of a file are wanted. */
  | { type: 'mesh'; mesh: string }
  /** The expanded robot is wanted, to be saved. */
  | { type: 'urdf' };
