// The state of the page, and what goes between it and the server (api.d.ts) as it has it. No code.
import type { ComponentChildren } from "preact";
import type * as api from "./api.d.ts";

export type Level = api.Level;
type Own = "also" | "wet" | "data";
/** A verdict of the server or of the page itself, which has no more of these than is shown. */
export type Verdict = Partial<Omit<api.Verdict, Own>> &
  Pick<api.Verdict, "level" | "text" | "sentences"> & {
    also?: Pick<api.Also, "level" | "name" | "text">[];
    wet?: Record<string, any> | null;
    data?: Record<string, any> | null;
  };
export type Table = Omit<api.Table, "key"> & { key: string };
export type TableRow = api.Row;
export type Bar = api.Bar;
export type Input = api.Input;
export type Book = api.Book;
export type BookLagging = api.BookLagging;
/** Rows of the catalogue, whose values are read by the keys of a file. */
type Keyed<T> = T & { [key: string]: any };
export type Belt = Keyed<api.CatalogueBelt>;
export type CatalogueLagging = Keyed<api.CatalogueLagging>;
export type Catalogue = Omit<api.Catalogue, "belts" | "laggings"> & {
  belts: Belt[];
  laggings: CatalogueLagging[];
};
/** One field of the drive file, from the schema, or of the page alone, which knows less of it. */
export type Spec = Pick<api.Field, "key" | "title" | "kind"> &
  Partial<Omit<api.Field, "slider">> & { slider?: Limits | null };
export interface Form {
  sections: { key: string; title: string; fields: Spec[] }[];
  criteria: string[];
  units: Record<string, any>;
  glossary: Record<string, any>;
  key_figures: { name: string; better: string; elsewhere: string[] }[];
}
/** A number of a text. */
export type Cell = Partial<api.NumberInText>;
/** A text in metric units with its numbers, one that is a number, or one that has none. */
export type Text =
  | string
  | api.TextWithNumbers
  | (Pick<api.Number, "text"> & Cell & { us?: undefined; cells?: undefined })
  | null
  | undefined;
/** What is wrong: told by the server, or found by the page, which knows less of it. */
export type Problem = Pick<api.ToldProblem, "path" | "message"> &
  Partial<api.ToldProblem> & {
    /** Of a drive that is right and that a page without a server does not solve. */
    beyond?: boolean;
  };
/** Numbers and columns by their names: what an arc that was not solved has none of is null. */
interface Numbers {
  status: string;
  numbers: Record<string, any>;
  profile: Record<string, any[]>;
}
/** An arc as numbers [SI]; those that JSON has none for are words. */
export type Prepared = Omit<api.Prepared, "law"> & { law: any };
export interface Judging {
  cases: (Omit<api.JudgedCase, "prepared"> & { prepared: Prepared })[];
}
type Solved<T> = Omit<
  T,
  keyof Numbers | "status" | "verdict" | "kind" | "tables" | "unbounded" | "prepared"
> &
  Numbers;
export type Arc = Solved<Omit<api.FastAnswer, "sequence" | "remarks">>;
export type QuickAnswer = Solved<api.FastAnswer> & {
  prepared: Prepared | null;
  /** Numbers of the page itself, not judged yet; the level is that of the drive before. */
  own?: boolean;
};
export type FullArc = Solved<Omit<api.WholeArc, "paper">> & {
  tables: Table[];
  paper: Numbers | null;
};
/** What is read of a whole answer, of the server or of the page itself. */
export type FullAnswer = Pick<api.SolveAnswer, "governing" | "remarks"> & {
  conditions: Table | null;
  checks: Table;
  summary: Table | null;
  verdict: Verdict;
  arcs: FullArc[];
  least_tension:
    | (Pick<api.LeastTension, "shown" | "sentence" | "level" | "raise_to"> & { table: Table })
    | null;
  sources: { kind: string }[];
  judging: Judging | null;
  /** Judged by the page, which tries single changes alone. */
  unsearched?: boolean;
};

export type Units = "si" | "us";
export type Children = ComponentChildren;
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

/** A design of the database that is on the page. */
export interface Saved {
  id: string;
  version: number;
  name: string;
  saved?: string;
}
/** The example that the design began as. */
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
  /** The text that the design was read from, and its document then. */
  source: Source | null;
  form: Form;
  catalogue: Catalogue;
  about: Record<string, any>;
  /** Whether the server does not answer. */
  gone: boolean;
  /** Whether it is another one than that of this window, or another start of it. */
  stranger: boolean;
  /** Whether it is of another version than the page. */
  newer: boolean;
  /** A new drive, which has values that nobody typed. */
  begun: boolean;
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
