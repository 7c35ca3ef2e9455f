// What goes between the page and the server, and the state of the page. No code.
import type { ComponentChildren } from "preact";

export type Units = "si" | "us";
export type Children = ComponentChildren;
export type Level = "NOT CHECKED" | "OK" | "ATTENTION" | "FAILS" | "FAULT OF THE PROGRAM";
/** The same text in both systems of units; some texts have no units and are plain. */
export type Text = string | { si: string; us: string } | null | undefined;
export type Path = (string | number)[];
export interface Limits {
  least: number;
  most: number;
  log: boolean;
}

/** A drive file as the server reads it: quantities are texts, as typed. */
export interface Design {
  title?: string;
  belt: Record<string, any>;
  pulley: Pulley[];
  lagging?: Record<string, any>;
  load_case?: LoadCase[];
  condition?: any;
  train?: Record<string, any>;
  [key: string]: any;
}
export interface Pulley {
  name?: string;
  lagging?: any;
  [key: string]: any;
}
export interface LoadCase {
  name?: string;
  pulley?: Record<string, any>;
  [key: string]: any;
}

/** One field of the drive file, from the schema. */
export interface Spec {
  key: string;
  title: string;
  kind: string;
  help?: string;
  symbol?: string;
  dimension?: string | null;
  required?: boolean;
  options?: string[];
  word?: string | null;
  default?: any;
  slider?: Limits | null;
  allowed?: string | null;
  least?: number | null;
  most?: number | null;
}
export interface Section {
  key: string;
  fields: Spec[];
}
export interface Form {
  sections: Section[];
  units: Record<string, any>;
  glossary: Record<string, any>;
}
export interface Belt {
  name: string;
  kind: string;
  [key: string]: any;
}
export interface CatalogueLagging {
  name: string;
  title: string;
  kind: string;
  source: string;
  conditions: string[];
  [key: string]: any;
}
export interface Catalogue {
  belts: Belt[];
  laggings: CatalogueLagging[];
  /** Conditions that published values cover, by surface. */
  published: Record<string, string[]>;
  examples: { name: string; title: string; kind: string }[];
}

export interface Problem {
  path: string;
  message: string;
  sentence?: string;
  /** Of a drive that is right and that a page without a server does not solve. */
  beyond?: boolean;
}
export interface Verdict {
  level: Level;
  told?: string;
  headline: Text;
  sentences: Text[];
}
export interface TableRow {
  name: string;
  title: string;
  symbol?: string;
  values: { si: string[]; us: string[] };
  note: Text;
  level: Level | null;
}
export interface Table {
  key: string;
  title: string;
  heads: { si: string[]; us: string[] };
  note: Text;
  rows: TableRow[];
}
export interface Arc {
  pulley: string;
  load_case: string;
  status: string;
  level: Level;
  levels: Record<string, Level>;
  creep_limit: number;
  numbers: Record<string, any>;
  profile: Record<string, any[]>;
  tested: { pressure_min: number; pressure_max: number; slip_max: number } | null;
  outside: [number, number][];
}
export interface FullArc extends Arc {
  bars: Bar[];
  short: string;
  status_text: string;
  /** Slack-side tension to raise to for this load case alone [N]. */
  raise_to: number | null;
  tables: Table[];
  table_sources: string[];
  paper: { status: string; numbers: Record<string, any>; profile: Record<string, any[]> } | null;
}
export interface QuickAnswer extends Arc {
  sequence: number;
  verdict: Verdict;
  remarks: Text[];
  prepared: Prepared | null;
  /** Numbers of the page itself, not judged yet; the verdict is that of the drive before. */
  own?: boolean;
}
/** An arc as numbers [SI]; those that JSON has none for are words. */
export interface Prepared {
  law: Record<string, number | number[]>;
  given: Record<string, number | string>;
  inputs: Input[];
}
/** A check without its numbers; `when` names the end of the arc that it is for, if one,
 * and after a colon where it slides. */
export interface Words {
  name: string;
  title: string;
  level: Level;
  place: string;
  value: number | string;
  limit: number | string;
  dimension: string;
  at_most: boolean;
  short: string;
  says: string;
  remedy: string;
  otherwise: string;
  more: Record<string, [number | string, string]>;
  binding: boolean;
  advises: boolean;
  numerical: boolean;
  leads: boolean;
  miss: Miss | null;
  when: string;
  pulley?: string;
}
/** What a check says that is not kept; far beyond its limit it fails, as `because` says, and up to
 * what it tolerates more may be allowed, as `allows` says. */
export interface Miss {
  level: Level;
  short: string;
  says: string;
  remedy: string;
  fails_beyond: number | string;
  because: string;
  tolerates: number | string;
  allows: string;
  otherwise: string;
}
/** What a check asks of the slack side, but for the tension. */
export interface Ask {
  name: string;
  title: string;
  what: string;
  place: string;
  binding: boolean;
  at_least: boolean;
}
/** What the page judges a drive of one pulley by. */
export interface Judging {
  levels: Level[];
  qualifier: string;
  take_up: boolean;
  least_name: string;
  counterweight: number;
  /** What a take-up elsewhere on the conveyor holds [N]; nan where it is at the drives. */
  held_at: number;
  checks: Words[];
  cases: {
    load_case: string;
    condition?: string;
    prepared: Prepared;
    elsewhere: Path[];
    tested: Arc["tested"];
    criteria: Record<string, number | string>;
    /** Compliance of a cover that the slip of the law may hold or not [m/Pa]. */
    cover?: number;
    checks: Words[];
    asks: Ask[];
    /** Of a pulley among others: its name, what it shares with these, its names for the words. */
    pulley?: string;
    among?: Record<string, number>;
    names?: Record<string, string>;
  }[];
  /** Of a drive that the page has put together: the load case that is meant where none is named. */
  meant?: string;
  /** Of a drive that the page has put together: what is said where load cases contradict the
   * take-up, what that holds, and names for the words. */
  odd?: Words | null;
  anew?: boolean;
  adrift?: boolean;
  held?: string;
  names?: Record<string, string>;
  kinds?: string[];
}
/** A number of the document that the page may move. */
export interface Input {
  path: Path;
  name: string;
  dimension: string;
  least: number | string;
  most: number | string;
  open: boolean;
}
/** A check against its limit; share is its value over the limit. */
export interface Bar {
  title: string;
  level: Level;
  place: string;
  at_most: boolean;
  share: number;
  found: Text;
  limit: Text;
  /** What it says where it is not kept, and where its limit came from. */
  says: Text;
  source: string;
}
export interface FullAnswer {
  verdict: Verdict;
  governing: { pulley: string; load_case: string };
  arcs: FullArc[];
  conditions: Table | null;
  checks: Table;
  least_tension: {
    shown: Text;
    sentence: Text;
    level: Level;
    table: Table;
    raise_to: number | null;
  } | null;
  summary: Table | null;
  sources: { kind: string }[];
  remarks: Text[];
  judging: Judging | null;
}

/** A design of the database that is on the page. */
export interface Saved {
  id: string;
  version: number;
  name: string;
  saved?: string;
}
/** The example that the design began as. */
export interface Origin {
  title: string;
  document: Design;
}
export interface Source {
  toml: string;
  document: Design;
}

export interface App {
  doc: Design;
  units: Units;
  page: string;
  pulley: number;
  case: string;
  name: string;
  design: Saved | null;
  origin: Origin | null;
  /** The text that the design was read from, and its document then. */
  source: Source | null;
  form: Form;
  catalogue: Catalogue;
  about: Record<string, any>;
  /** Whether the server does not answer. */
  gone: boolean;
  /** Whether it is of another version than the page. */
  newer: boolean;
  /** Whether a part of the page did not come. */
  lacks: boolean;
  /** Another one whenever a design is opened. */
  opened: number;
}

export interface Line {
  y: (number | null)[];
  x?: number[];
  cls: string;
  label?: string;
  free?: boolean;
}
export interface ChartData {
  x: number[];
  lines: Line[];
  xs?: [number, number];
  ylabel: string;
  zero?: boolean;
  angles?: boolean;
  zones?: [number, number, string][];
  limit?: { y: number; label: string };
  points?: [number, number, string?][];
  pointLabel?: string;
  told?: string;
  other?: { label: string; key: number; to: (v: number) => number; from: (v: number) => number };
}
export interface ChartLook {
  title: string;
  height?: number;
  xlabel?: string;
  onpick?: (part: number) => void;
  /** One of several under each other on one axis: even margins, names at the lines. */
  stacked?: boolean;
  /** Whether the axis has its numbers, as only the lowest of several does. */
  numbered?: boolean;
}

/** Numbers as JSON has them: those that it has none for are words. */
export type Number_ = number | string;
/** What drives of one pulley are put together from: see web/answers/book.py. */
export interface Book {
  levels: Level[];
  laggings: Record<string, BookLagging>;
  catalogue: { belts: any[]; laggings: Record<string, any> };
  words: Record<string, Words[]>;
  asks: Record<string, Ask>;
  standards: {
    rows: {
      standard: string;
      surface: string;
      condition: string;
      friction: Number_;
      rule: string;
    }[];
    manual: Record<string, { angle: Number_; factor: Number_; rule: string }[]>;
    own: string;
    silent: Record<string, string>;
  };
  grounds: Record<string, string>;
  weak_kinds: string[];
  more_creep: Record<string, number>;
  customary_safety: Record<string, number>;
  least_names: Record<string, string>;
  held: Record<string, string>;
  heads: { checks: Table; least: Record<string, Table> };
  usual: Record<string, number>;
  sizes: Record<string, Record<string, [number, number]>>;
  load: [number, number];
  steepest: number;
  design: string;
  own: Record<string, any>;
}
export interface BookLagging {
  name: string;
  first: string;
  laws: Record<string, BookLaw>;
  /** What wet leaves of its dry friction: nan if not known, 0 where it was not tested dry. */
  wet: Number_;
}
export interface BookLaw {
  condition: string;
  law: Record<string, number | number[]>;
  steepest_fall: number;
  slip_with_shear: boolean;
  tested: Record<string, Number_> | null;
  grounds: string[];
  told: string[];
  checks: Words[];
}
