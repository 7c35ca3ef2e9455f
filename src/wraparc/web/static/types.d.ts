// What goes between the page and the server, and the state of the page. No code.
import type { ComponentChildren } from "preact";

export type Units = "si" | "us";
export type Children = ComponentChildren;
export type Level = "NOT CHECKED" | "OK" | "ATTENTION" | "FAILS" | "FAULT OF THE PROGRAM";
/** A number of a text, see NumberInText of the API. */
export interface Cell {
  at?: [number, number];
  value: number;
  from?: number;
  apart?: number;
  name?: string;
  dimension?: string;
  digits?: number;
  form?: string;
}
/** A text in metric units with its numbers, one that is a number, or one that has none. */
export type Text =
  | string
  | { text: string; us?: string; cells: (Cell & { at: [number, number] })[] }
  | ({ text: string; us?: undefined; cells?: undefined } & Cell)
  | null
  | undefined;
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
  /** What kind it is: `missing`, `few_tensions`, or nothing. */
  code?: string;
  sentence?: string;
  /** Of a drive that is right and that a page without a server does not solve. */
  beyond?: boolean;
}
export interface Verdict {
  level: Level;
  word?: string;
  headline: Text;
  action?: Text;
  sentences: Text[];
}
export interface TableRow {
  name: string;
  title: Text;
  symbol?: string;
  values: Text[];
  note: Text;
  level: Level | null;
}
export interface Table {
  key: string;
  /** Word that `--table` asks for it by. */
  name: string;
  title: Text;
  heads: Text[];
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
/** What the server has solved of a drive of one pulley, for the page to move its numbers. */
export interface Judging {
  cases: { load_case: string; prepared: Prepared; elsewhere: Path[] }[];
}
/** A drive that the page has put together: as the program reads it, and its arcs in numbers. */
export interface Assembled {
  drive: any;
  arcs: any[];
  cases: {
    load_case: string;
    pulley: string;
    lagging: string;
    condition: string;
    belt: string;
    prepared: { law: any; given: Record<string, number>; inputs: Input[] };
    tested: any;
    criteria: Record<string, number>;
  }[];
  kinds: string[];
  /** The load case that is meant where none is named. */
  meant: string;
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
  name: string;
  /** What is held against the limit [SI]. */
  value: number;
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
  onpick?: (part: number, e: PointerEvent) => void;
  /** One of several under each other on one axis: even margins, names at the lines. */
  stacked?: boolean;
  /** Whether the axis has its numbers, as only the lowest of several does. */
  numbered?: boolean;
}

/** What the page reads drives with: see web/answers/book.py. */
export interface Book {
  laggings: Record<string, BookLagging>;
  catalogue: { belts: any[]; laggings: Record<string, any> };
  own: Record<string, any>;
}
export interface BookLagging {
  laws: Record<string, { condition: string; law: any; steepest_fall: number }>;
}
