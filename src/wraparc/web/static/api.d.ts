// Made by `make kernel` from the document of the API. No code.
export interface About {
  name: string;
  version: string;
  database: string;
  extras: Record<string, boolean>;
  token: boolean;
}
export interface AcrossAnswer {
  pulley: string;
  load_case: string;
  even: boolean;
  solved: boolean;
  status_text: Text;
  verdict: Verdict;
  remarks: Text[];
  bars: Bar[];
  checks: Table | null;
  tables: Table[];
  numbers: Record<string, number | null>;
  levelling_depth: (number | null)[];
  rating: number | null;
  map: WidthMap | null;
  profiles: WidthProfiles | null;
}
export interface AcrossRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** The first if left out. */
  pulley?: string | null;
  /** The running one of maximum effective tension if left out. */
  load_case?: string | null;
}
export interface AcrossThicknessAnswer {
  verdict: Verdict;
  table: Table;
}
export interface AcrossThicknessRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** The first if left out. */
  pulley?: string | null;
  /** The running one of maximum effective tension if left out. */
  load_case?: string | null;
  thicknesses: string[];
}
export interface AcrossWearAnswer {
  verdict: Verdict;
  table: Table;
  heals: boolean;
  grows: boolean;
  relag_hours: number | null;
  mean_depth: (number | null)[];
  unevenness: (number | null)[];
  position: (number | null)[];
  thickness: (number | null)[][];
}
export interface AcrossWearRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** The first if left out. */
  pulley?: string | null;
  /** The running one of maximum effective tension if left out. */
  load_case?: string | null;
  /** Mean depth to wear off; or `passes`; on to re-lagging if left out. */
  depth?: string | null;
  /** Turns of the pulley. */
  passes?: number | null;
  /** Of the thinnest strip when re-lagged. */
  least_thickness?: string;
  /** Run since the lagging was new, for its wear rate. */
  hours?: number | null;
}
export interface Action {
  text: Text;
  ways: Way[];
}
export interface ActionAnswer {
  sequence: number;
  action: Action | null;
}
export interface ActionRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** Only this one. */
  load_case?: string | null;
  /** Returned unchanged. */
  sequence?: number;
}
export interface Also {
  level: Level;
  name: string;
  place: Record<string, string | number | null> | null;
  quantity: string | null;
  value: number | null;
  limit: number | null;
  unit: string | null;
  relation: "exceeds" | "below" | "within" | "none";
  used: number | null;
  text: Text;
}
export interface Bar {
  name: string;
  title: string;
  level: Level;
  place: Text;
  at_most: boolean;
  value: number;
  share: number;
  found: Text;
  limit: Text;
  says: Text;
  source: string;
}
export interface Body_add_api_v1_logs__session__files_post {
  /** Logs. */
  files: string[];
}
export interface Body_add_api_v1_tests__session__files_post {
  /** Machine files. */
  files: string[];
}
export interface Body_measured_profile_api_v1_across_profile_post {
  /** Positions and readings over the face. */
  file: string;
  width?: string;
  unit?: string;
  "new"?: string;
}
export interface Book {
  laggings: Record<string, BookLagging>;
  catalogue: BookCatalogue;
  own: Record<string, any>;
}
export interface BookCatalogue {
  belts: Record<string, any>[];
  laggings: Record<string, Record<string, any>>;
}
export interface BookLagging {
  laws: Record<string, BookLaw>;
}
export interface BookLaw {
  condition: string;
  law: Law;
  steepest_fall: number | "NaN" | "Infinity" | "-Infinity";
}
export interface Candidate {
  name: string;
  title: string;
  condition: string;
  level: Level;
  label: string;
  short: string;
  status_text: string;
  cells: Record<string, Compared>;
  cost_note: string;
  kind: string;
  source: string;
  change: wraparc__web__answers__compare__Change[];
  present: boolean;
}
export interface Catalogue {
  belts: CatalogueBelt[];
  laggings: CatalogueLagging[];
  published: Record<string, string[]>;
  design_friction: DesignFriction[];
  examples: CatalogueExample[];
}
export interface CatalogueBelt {
  name: string;
  kind: string;
  rating: Text;
  modulus: Text;
  modulus_test: string;
  least_pulley_diameter: Text | null;
  source: string;
}
export interface CatalogueExample {
  name: string;
  title: string;
  kind: "drive" | "train";
  pulleys: number;
}
export interface CatalogueLagging {
  name: string;
  title: string;
  surface: string;
  conditions: string[];
  thickness: Text;
  shear_modulus: Text;
  compression_modulus: Text;
  kind: Kind;
  source: string;
  tested: TestedTexts | null;
  notes: string[];
}
export interface CheckRequest {
  document?: Record<string, any> | null;
  toml?: string | null;
}
export interface ChooseRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  pulley?: string | null;
  laggings?: string[];
  belts?: string[];
  thicknesses?: string[];
  diameters?: string[];
  wrap_angles?: string[];
  slack_tensions?: string[];
  /** Each design with its minimum T2. */
  least_slack?: boolean;
  currency?: string;
  years?: number;
  tariff?: number | null;
  /** Of a year, by load case. */
  hours?: Record<string, number>;
}
export interface Column {
  key: string;
  title: string;
  better: string;
  meaning: string;
}
export interface CompareAnswer {
  pulley: string;
  load_case: string;
  load_cases: number;
  what: "laggings" | "belts";
  currency: string;
  years: number;
  present: string;
  columns: Column[];
  rows: Candidate[];
  remarks: Text[];
  not_possible: Impossible[];
}
export interface CompareRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  pulley?: string | null;
  load_case?: string | null;
  what?: "laggings" | "belts";
  names?: string[] | null;
  years?: number;
  hours?: number;
  tariff?: number | null;
  currency?: string;
}
export interface Compared {
  value: number | null;
  text: Text;
}
export interface Curve {
  axis: string;
  values: (number | null)[];
  shares: Record<string, (number | null)[]>;
  exit_creep: Record<string, (number | null)[]>;
  loss_ratio: (number | null)[];
  marks: Mark[];
}
export interface Curves {
  slip: (number | null)[];
  pressures: (number | null)[];
  friction: (number | null)[][];
  tested_slip: number | null;
}
export interface DesignAnswer {
  id: number;
  name: string;
  kind: "drive" | "train";
  versions: VersionRow[];
  newest: number;
  created: string;
  changed: string;
  who: string;
  note: string;
}
export interface DesignFriction {
  standard: string;
  surface: string;
  condition: string;
  friction: number[];
  source: string;
}
export interface DesignRequest {
  name: string;
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  note?: string;
  who?: string;
}
export interface DesignRow {
  id: number;
  name: string;
  kind: "drive" | "train";
  versions: number;
  created: string;
  changed: string;
  who: string;
  note: string;
}
export interface Designs {
  total: number;
  designs: DesignRow[];
}
export interface DigitisedCurve {
  name: string;
  points: number;
  pressure: string | null;
}
export interface DocumentRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
}
export interface DrumPlayed {
  name: string;
  diameter: number;
  wrap_angle: number;
  belt_thickness: number | null;
  creep_limit: number;
  entry_tension: (number | null)[];
  exit_tension: (number | null)[];
  speed: (number | null)[];
  torque: (number | null)[];
  share: (number | null)[];
  exit_creep: (number | null)[];
  peak_shear: (number | null)[];
  creep: (number | null)[][];
  shear: (number | null)[][];
}
export interface EventRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  what?: "run" | "stability" | "map";
  /** The first if left out. */
  event?: string | null;
  /** Pieces of lagging on the shortest wrap. */
  points?: number;
  /** Time step; chosen if left out. */
  step?: string | null;
  /** Amplitude that the answers refer to. */
  run_out?: string;
  /** What a map goes over. */
  over?: "droop" | "coupling slip";
}
export interface ExampleAnswer {
  name: string;
  kind: "drive" | "train";
  document: Record<string, any>;
  toml: string;
}
export interface ExportRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  units?: "si" | "us";
  /** Name of the file, without its ending. */
  name?: string;
}
export interface FastAnswer {
  pulley: string;
  load_case: string;
  status: "solved" | "breakaway" | "unsolved";
  level: Level;
  levels: Record<string, Level>;
  creep_limit: number;
  numbers: Record<string, number | null>;
  profile: Profile;
  tested: Tested | null;
  outside: [number, number][];
  tables: Table[];
  sequence: number;
  kind: "drive" | "train";
  verdict: Verdict;
  remarks: Text[];
  prepared: Prepared | null;
}
export interface FastRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** The first if left out. */
  pulley?: string | null;
  /** The running one of maximum effective tension if left out. */
  load_case?: string | null;
  /** Whether that pulley and load case are meant that govern the verdict. */
  governing?: boolean;
  /** Parts of the wrap in the profile. */
  points?: number;
  /** Whether to send tables as well. */
  tables?: boolean;
  /** Whether to send the arc as numbers, of which the page goes on itself. */
  prepared?: boolean;
  /** Returned unchanged. */
  sequence?: number;
}
export interface Field {
  key: string;
  path: string;
  title: string;
  symbol: string;
  help: string;
  kind: string;
  required: boolean;
  options: string[];
  word: string | null;
  default: string | boolean | null;
  slider: Slider | null;
  dimension?: string | null;
  allowed?: string;
  least?: number | null;
  most?: number | null;
  usual?: [number, number] | null;
}
export interface Figure {
  name: string;
  better: string;
  elsewhere: string[];
}
export interface FileAnswer {
  read?: boolean;
  digitised?: DigitisedCurve[];
  problems?: ToldProblem[];
  tables?: Table[];
  columns?: FileColumn[];
  notes?: string[];
  preview?: Preview | null;
  pressure_guess?: string | null;
  condition_guess?: string | null;
  number?: string | null;
  place?: string;
  id: string;
  name: string;
  bytes: number;
  pressure: string | null;
  normal_force: string | null;
  condition: string;
  repeat: string;
  sample: string;
  use: boolean;
  reason: string;
  choices: FileChoices;
  curve_pressures: Record<string, string>;
  more: Record<string, any>;
  illustrative: boolean;
}
export interface FileChoices {
  travel?: string | number | null;
  force?: string | number | null;
  normal_force?: string | number | null;
  time?: string | number | null;
  units?: Record<string, string> | null;
  decimal?: string | null;
  delimiter?: string | null;
  encoding?: string | null;
  sheet?: string | null;
  table?: number | null;
  block?: number | null;
  stress_area?: string | null;
  stroke?: string | null;
  stick_slip?: string | null;
}
export interface FileColumn {
  name: string;
  unit: string;
  role: string;
}
export interface FilesAnswer {
  files: FileAnswer[];
}
export interface Finding {
  title: string;
  level: Level;
  value: Text;
  text: Text;
  tests: number | null;
}
export interface FitAnswer {
  name: string;
  lagging: Record<string, any> | null;
  toml: string | null;
  sheet: Sheet;
  conditions: FittedCondition[];
  left_out: ToldProblem[];
  removes_shear: boolean;
}
export interface FitRequest {
  lagging: Record<string, any>;
  rig: Record<string, any>;
  fit?: Record<string, any>;
  /** Other tables of the plan: columns, all_tests, uncertainty, report ... */
  more?: Record<string, any>;
  accept_misfit?: string;
}
export interface FittedCondition {
  condition: string;
  findings: Finding[];
  misfit: string[];
  remarks: string[];
  curves: FittedCurve[];
  pressure_functions: PressureFunctions;
  at_slips: FrictionAtSlip[];
  transition: Transition | null;
}
export interface FittedCurve {
  file: string;
  pressure: number;
  slip: (number | null)[];
  friction: (number | null)[];
  fitted: (number | null)[];
  peak_friction: number | null;
  peak_slip: number | null;
  lash: number | null;
  noise: number | null;
  flagged: boolean;
  misfit: string[];
}
export interface Form {
  version: string;
  key_figures: Figure[];
  units: Record<string, Units>;
  glossary: Record<string, Term>;
  sections: Section[];
  criteria: string[];
}
export interface FoundValue {
  value: number;
  shown: Text;
  level: Level;
  label: string;
  text: Text;
}
export interface FrictionAtSlip {
  slip: number;
  pressure: (number | null)[];
  friction: (number | null)[];
  band: (number | null)[];
  points: [number, number][];
}
export interface Impossible {
  name: string;
  problems: ToldProblem[];
}
export interface Input {
  path: (string | number)[];
  name: string;
  dimension: Dimension;
  least: number | "NaN" | "Infinity" | "-Infinity";
  most: number | "NaN" | "Infinity" | "-Infinity";
  open: boolean;
}
export interface JobAnswer {
  id: string;
  state: "queued" | "running" | "done" | "failed" | "cancelled";
  done: number;
  total: number;
  message: string;
  problems: ToldProblem[];
  title: string;
}
export interface JobsAnswer {
  jobs: JobAnswer[];
}
export interface JudgedCase {
  load_case: string;
  prepared: Prepared;
  elsewhere: (string | number)[][];
}
export interface Judging {
  cases: JudgedCase[];
}
export type Kind = "measured" | "published" | "calibrated" | "illustrative" | "given";
export interface LaggingAnswer {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  name: string;
  condition: string;
  document: Record<string, any>;
  law: Curves;
}
export interface LaggingRequest {
  toml: string;
}
export interface Law {
  kind: number;
  edges: number[];
  coefficients: number[];
  slips: number[];
  onset_compliance: number;
}
export interface LearnRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** Tables of a learn file; its drive is `document`, its logs are uploaded. */
  learn?: Record<string, any>;
}
export interface LearningAnswer {
  id: string;
  state: "queued" | "running" | "done" | "failed" | "cancelled";
  done: number;
  total: number;
  message: string;
  problems: ToldProblem[];
  title?: Text | null;
  subtitle?: Text | null;
  verdict?: Verdict | null;
  tables?: Table[] | null;
  remarks?: Text[] | null;
  table_sources?: string[] | null;
  summary?: Record<string, any> | null;
  findings?: LogFinding[] | null;
  pictures?: string[] | null;
  toml?: string | null;
  name?: string | null;
}
export interface LeastTension {
  tension: number | null;
  given: number | null;
  counterweight: number | null;
  governing: string;
  level: Level;
  raise_to: number | null;
  shown: Text;
  sentence: Text;
  table: Table;
}
export type Level = "NOT CHECKED" | "OK" | "ATTENTION" | "FAILS" | "INTERNAL ERROR";
export interface LinkAnswer {
  href: string;
}
export interface LogFile {
  id: string;
  name: string;
  bytes: number;
}
export interface LogFiles {
  session: string;
  expires_in: number;
  files: LogFile[];
}
export interface LogFinding {
  title: string;
  value: Text;
  text: Text;
}
export interface Map {
  across: string;
  down: string;
  x: (number | null)[];
  y: (number | null)[];
  shares: Record<string, (number | null)[][]>;
}
export interface Mark {
  what: string;
  pulley: string;
  at: number | null;
  shares: (number | null)[];
  loss_ratio: number | null;
}
export interface Marks {
  illustrative: boolean;
  calibrated: boolean;
  outside_tested: boolean;
}
export interface MatchingPart {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  format: number;
  program: Record<string, string>;
  file: string;
  drive: string;
  load_case: Record<string, any>;
  equal_shares: Record<string, any>;
  curves: Curve[];
  changes: Record<string, any>[];
  map?: Map | null;
}
export interface MeasuredAnswer {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  picture: string;
  lagging: Record<string, any> | null;
  file: string;
}
export interface MeasuredFile {
  name: string;
  /** Its bytes in base 64. */
  data: string;
}
export interface MeasuredRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  pulley?: string | null;
  load_case?: string;
  parameters?: ("friction" | "peak_slip" | "shear_modulus")[];
  files: MeasuredFile[];
}
export interface Number {
  value: number | null;
  from?: number;
  apart?: number;
  error?: number;
  unit: string;
  name?: string;
  dimension?: Dimension;
  digits?: number;
  form?: CellForm;
  text: string;
}
export interface NumberInText {
  value: number | null;
  from?: number;
  apart?: number;
  error?: number;
  unit: string;
  name?: string;
  dimension?: Dimension;
  digits?: number;
  form?: CellForm;
  at: [number, number];
}
export interface OnSiteRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  pulley?: string | null;
  /** Of a year, by load case. */
  hours?: Record<string, number>;
  wear_hours?: Record<string, number>;
  wear_coefficient?: string;
  measured_wear?: string;
  depth?: string;
}
export interface Paper {
  status: "solved" | "breakaway" | "unsolved";
  numbers: Record<string, number | null>;
  profile: Profile;
}
export interface Place {
  pulley: string;
  load_case: string;
}
export interface PlanAnswer {
  toml: string;
  name: string;
}
export interface Played {
  event: string;
  outcome: "whole" | "slack" | "breakaway" | "turned-back" | "cancelled";
  duration: number;
  time: (number | null)[];
  travel: (number | null)[];
  belt_speed: (number | null)[];
  frame_time: (number | null)[];
  drums: DrumPlayed[];
}
export interface Prepared {
  law: Law;
  given: Record<string, number | "NaN" | "Infinity" | "-Infinity">;
  inputs: Input[];
}
export interface PressureFunctions {
  points: PressurePoint[];
  pressure?: (number | null)[];
  peak_slip?: (number | null)[];
  peak_friction?: (number | null)[];
}
export interface PressurePoint {
  file: string;
  pressure: number;
  peak_slip: number | null;
  peak_friction: number | null;
}
export interface Preview {
  travel: (number | null)[];
  force: (number | null)[];
}
export interface Problems {
  type?: string;
  title: string;
  status: number;
  detail: string;
  problems: ToldProblem[];
}
export interface Profile {
  position: (number | null)[];
  tension: (number | null)[];
  wrap_pressure: (number | null)[];
  friction: (number | null)[];
  friction_used: (number | null)[];
  slip: (number | null)[];
  creep: (number | null)[];
  shear_stress: (number | null)[];
  shear_angle: (number | null)[];
  sliding: (number | null)[];
}
export interface ProfileAnswer {
  key: string;
  profile: string[][] | Record<string, any>;
  readings: number;
  told: Text[];
}
export interface QuantitiesAnswer {
  items: Quantity[];
}
export interface QuantitiesRequest {
  items: QuantityItem[];
}
export interface Quantity {
  value?: number | null;
  text?: Text | null;
  exact?: Text | null;
  problem?: ToldProblem | null;
}
export interface QuantityItem {
  text: string;
  dimension: string;
}
export interface ReadAnswer {
  kind: "drive" | "train";
  valid: boolean;
  problems: ToldProblem[];
  document: Record<string, any>;
}
export interface ReadLaggingAnswer {
  name: string;
  title: string;
  lagging: Record<string, any>;
}
export interface RenameRequest {
  name: string;
}
export interface ReportHead {
  title?: string;
  project?: string;
  number?: string;
  revision?: string;
  author?: string;
  date?: string;
  paper?: "a4" | "us-letter";
}
export interface ReportRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  units?: "si" | "us";
  /** Name of the file, without its ending. */
  name?: string;
  head?: ReportHead;
}
export interface ReserveAnswer {
  sequence: number;
  text: Text | null;
  changes: ReserveChange[];
}
export interface ReserveChange {
  input: string;
  pulley: string | null;
  lagging: string | null;
  load_case: string | null;
  change: number;
  level: Level;
  uncertainty: number;
  uncertainty_kind: string;
  source: string | null;
  name: Text;
  shown: Text;
  changes: wraparc__web__answers__shown__Change[];
}
export interface Row {
  name: string;
  title: Text;
  symbol: string;
  values: Text[];
  note: Text;
  level: Level | null;
}
export interface RunAnswer {
  id: string;
  state: "queued" | "running" | "done" | "failed" | "cancelled";
  done: number;
  total: number;
  message: string;
  problems: ToldProblem[];
  title: string;
  run?: Sheet | null;
  bars?: Bar[] | null;
  stability?: Sheet | null;
  note?: string | null;
  played?: Played | null;
  pictures?: string[] | null;
}
export interface RunsAnswer {
  jobs: RunAnswer[];
}
export interface Section {
  key: string;
  title: string;
  repeated: boolean;
  fields: Field[];
}
export interface SeekAnswer {
  sentence: Text;
  found: FoundValue[];
  tried: (number | null)[];
  results: (number | null)[];
}
export interface SeekRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** Key path of the input. */
  field: string;
  /** Name of the result in the glossary. */
  result: string;
  /** What it is to be, with its unit. */
  value: string;
  pulley?: string;
  load_case?: string;
  /** Minimum input; a third of the present one if left out. */
  least?: string;
  /** Most; three times the present one if left out. */
  most?: string;
  /** The present input where a preset gives it. */
  now?: string;
}
export interface SessionAnswer {
  session: string;
  expires_in: number;
  limits: Record<string, number>;
}
export interface SessionFiles {
  files: FileAnswer[];
  expires_in: number;
}
export interface Sheet {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
}
export interface SheetAnswer {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  kind: "drive" | "train";
}
export interface Slider {
  least: number;
  most: number;
  step: number;
  log: boolean;
}
export interface SolveAnswer {
  sequence: number;
  kind: "drive" | "train";
  title: string;
  description: string;
  solved: boolean;
  within_creep_limit: boolean;
  governing: Place;
  verdict: Verdict;
  remarks: Text[];
  conditions: Table | null;
  checks: Table;
  least_tension: LeastTension | null;
  summary: Table | null;
  sources: Source[];
  has: Marks;
  arcs: WholeArc[];
  train: TrainPart | null;
  judging: Judging | null;
}
export interface SolveRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  /** Only this one. */
  load_case?: string | null;
  points?: number;
  /** Whether to send the checks as numbers, of which the page goes on. */
  prepared?: boolean;
  /** Whether changes are tried for the action; else see `/solve/action`. */
  search?: boolean;
  sequence?: number;
}
export interface Source {
  of: string;
  part: string;
  kind: Kind;
  source: string;
  date: string;
  note: string;
}
export interface Spread {
  result: string;
  where: Text;
  edges: number[];
  counts: number[];
  limit: number | null;
  limit_told: Text;
  at_most: boolean;
  beyond: number;
  without: number;
  told: Text;
}
export interface StartAnswer {
  name: string;
  kind: "drive" | "train";
  document: Record<string, any>;
  toml: string;
  file: string | null;
}
export interface StartSolved {
  quick: FastAnswer;
  whole: SolveAnswer;
}
export interface StudyAnswer {
  id: string;
  state: "queued" | "running" | "done" | "failed" | "cancelled";
  done: number;
  total: number;
  message: string;
  problems: ToldProblem[];
  title: string;
  study?: Record<string, any> | null;
  document?: Record<string, any> | null;
  subtitle?: Text | null;
  verdict?: Verdict | null;
  tables?: Table[] | null;
  remarks?: Text[] | null;
  table_sources?: string[] | null;
  summary?: Record<string, any> | null;
  spreads?: Spread[] | null;
  pictures?: string[] | null;
  files?: string[] | null;
}
export interface StudyRequest {
  /** Tables of a study file; its drive is `document`. */
  study: Record<string, any>;
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
}
export interface Table {
  key?: string;
  name: string;
  title: Text;
  heads: Text[];
  note: Text;
  rows: Row[];
}
export interface Term {
  symbol: string;
  dimension: string;
  title: string;
  meaning: string;
}
export interface TestFileRequest {
  pressure?: string | null;
  normal_force?: string | null;
  condition?: string;
  repeat?: string;
  sample?: string;
  use?: boolean;
  reason?: string;
  choices?: FileChoices;
  /** Of the curves of a digitised file, by their names. */
  curve_pressures?: Record<string, string>;
  /** Other keys of its test in a plan: speed, temperature, lot ... */
  more?: Record<string, any>;
  illustrative?: boolean;
}
export interface Tested {
  pressure_min: number;
  pressure_max: number;
  slip_max: number;
}
export interface TestedTexts {
  pressure: Text;
  slip: Text;
}
export interface TextWithNumbers {
  text: string;
  cells: NumberInText[];
  us?: string;
}
export interface ToldProblem {
  path: string;
  message: string;
  value: string;
  remedy: string;
  line: number | null;
  code: string;
  meant: string;
  sentence: string;
}
export interface TomlRequest {
  toml: string;
  name?: string;
}
export interface TrainAnswer {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  solved: boolean;
  least_tension: Record<string, any> | null;
  load_cases: Record<string, any>[];
  sources: Source[];
  judged: Verdict[];
  matching: MatchingPart | null;
}
export interface TrainPart {
  title: Text;
  subtitle: Text;
  verdict: Verdict | null;
  tables: Table[];
  remarks: Text[];
  table_sources: string[];
  solved: boolean;
  least_tension: Record<string, any> | null;
  load_cases: Record<string, any>[];
  sources: Source[];
}
export interface TrainRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  load_case?: string | null;
  match?: boolean;
  /** Drive to vary; the second if left out. */
  drive?: string | null;
  /** Ends of the trims. */
  span?: string[] | null;
  points?: number;
  wear?: string;
  map?: boolean;
}
export interface Transition {
  pressure: number | null;
  given: boolean;
  in_law: boolean;
}
export interface Unit {
  unit: string;
  factor: number;
  larger: [number, string, number, number][];
}
export interface Units {
  si: Unit;
  us: Unit;
  choices: string[];
  factors: Record<string, number>;
  example: string;
}
export interface Verdict {
  level: Level;
  label: string;
  name: string;
  place: Record<string, string | number | null> | null;
  quantity: string | null;
  value: number | null;
  limit: number | null;
  unit: string | null;
  relation: "exceeds" | "below" | "within" | "none";
  used: number | null;
  text: Text;
  action: Action | null;
  changes: Text[];
  also: Also[];
  wet: Record<string, any> | null;
  reserve: Record<string, any>[];
  reserve_text: Text | null;
  probability: Record<string, any> | null;
  data: Record<string, any> | null;
  passed: number | null;
  missed: number | null;
  not_checked: string[];
  sentences: Text[];
}
export interface VersionAnswer {
  version: number;
  created: string;
  who: string;
  note: string;
  program: string;
  id: number;
  name: string;
  kind: "drive" | "train";
  document: Record<string, any>;
}
export interface VersionRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  note?: string;
  who?: string;
  /** The version it was made from. */
  base: number;
  /** A new name of the design. */
  name?: string | null;
}
export interface VersionRow {
  version: number;
  created: string;
  who: string;
  note: string;
  program: string;
}
export interface Way {
  changes: wraparc__web__answers__shown__Change[];
  proved: boolean;
  left: number;
  text: Text;
}
export interface WhatIfRequest {
  /** Tables of a drive file: the same keys and the same texts for quantities. */
  document: Record<string, any>;
  pulley?: string | null;
  load_case?: string | null;
  other_carcass?: boolean;
  belts?: string[];
  laggings?: string[];
  thicknesses?: string[];
  worn?: string[];
  /** Friction when wet over dry, or "DIN 22101". */
  wet?: string;
  /** "CEMA" or "DIN 22101". */
  bare?: string;
}
export interface WholeArc {
  pulley: string;
  load_case: string;
  status: "solved" | "breakaway" | "unsolved";
  level: Level;
  levels: Record<string, Level>;
  creep_limit: number;
  numbers: Record<string, number | null>;
  profile: Profile;
  tested: Tested | null;
  outside: [number, number][];
  tables: Table[];
  bars: Bar[];
  status_text: string;
  short: string;
  order: number;
  raise_to: number | null;
  unbounded: string[];
  table_sources: string[];
  paper: Paper;
}
export interface WidthMap {
  angle: (number | null)[];
  position: (number | null)[];
  shear_stress: (number | null)[][];
  creep: (number | null)[][];
  wrap_pressure: (number | null)[][];
  frictional_energy: (number | null)[][];
}
export interface WidthProfiles {
  entry_tension: (number | null)[];
  exit_tension: (number | null)[];
  static_tension: (number | null)[] | null;
  radius_deviation: (number | null)[];
  thickness: (number | null)[];
  frictional_energy: (number | null)[];
}
export interface WriteAnswer {
  kind: "drive" | "train";
  valid: boolean;
  problems: ToldProblem[];
  toml: string;
  name: string;
}
export interface wraparc__web__answers__compare__Change {
  path: string;
  value: string | null;
}
export interface wraparc__web__answers__shown__Change {
  key: string;
  from: number | string;
  to: number | string;
  unit: string | null;
}
export type Text = string | Number | TextWithNumbers;
export type Dimension =
  | "length"
  | "force"
  | "force_per_width"
  | "spring_rate"
  | "pressure"
  | "pressure_per_length"
  | "speed"
  | "angle"
  | "power"
  | "torque"
  | "area"
  | "time"
  | "temperature"
  | "per_length"
  | "wear_coefficient"
  | "energy_per_area"
  | "power_per_area"
  | "rotation_speed"
  | "frequency"
  | "mass"
  | "mass_per_length"
  | "mass_flow"
  | "density"
  | "moment_of_inertia"
  | "number";
export type CellForm =
  | ""
  | "bare"
  | "unit"
  | "percent"
  | "up"
  | "bare up"
  | "down"
  | "slip"
  | "apart"
  | "slip apart"
  | "maximum"
  | "minimum"
  | "exceeds"
  | "below"
  | "to"
  | "-"
  | "to up"
  | "to down"
  | "of"
  | "bare error"
  | "fixed"
  | "signed"
  | "percent fixed"
  | "percent signed"
  | "grouped"
  | "typed";
