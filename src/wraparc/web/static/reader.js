// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import { answer__operating_point, compression__block_modulus, compression__shape_factor, load_case__exit_behind, numbers__idles, pitch__centrifugal_force, summary__geometry_of, summary__held_creep, summary__overrun_loosens, summary__recovery_compliance, summary__too_steep, tension_rules__behind_take_up, tension_rules__effective_keys, tension_rules__ends_of, tension_rules__families, tension_rules__fault_of, tension_rules__filled, tension_rules__less_runs, tension_rules__overridden, tension_rules__pull_given, tension_rules__speed_missing, tension_rules__too_few } from "./kernel.js";
import { cell__quantity } from "./cells.js";
import { cellOf } from "./base/digits.js";
import { belts, isNumber, laggingNames, laggingText, overridden, parsed, readText, term } from "./documents.js";
import { $Decimal, $Dict, $Error, $KeyError, $Object, $OverflowError, $StopIteration, $TypeError, $ValueError, $add, $and, $at, $b, $bound, $call, $common, $eq, $fields, $format, $in, $iter, $k, $kept, $m, $made, $map, $math, $merged, $method, $mul, $neg, $once, $or, $pow, $put, $re, $replaced, $repr, $shown, $sig, $slice, $str, $sub, $told, $truth } from "./python.js";
function drive_file__drive_from_document(document, file = "", folder = "", overrides = [], allow_paths = false) {
let belt, belt_record, cases, conditions, conveyor, criteria, laggings, message, own, parts, pulleys, record, records, report;

(document = overridden(document, overrides, file));
if (($in("train", document))) {
source__check_format(document, file);
(report = new Report(file));
(message = "a train of drives on one belt, which is no plain drive");
report.add(["train"], message, "Read it with wraparc.load_train or wraparc.load_drive.");
report.raise_all();
}
([record, report] = source__read_tables($c0, document, file));
(belt_record = $m.get(record, "belt"));
(belt = ($truth($b.isinstance(belt_record, Record)) ? drive_build__build_belt(belt_record, report) : null));
(own = $m.get(record, "lagging"));
(laggings = new Laggings(($truth($b.isinstance(own, "dict")) ? own : $map([])), folder, allow_paths, report));
(records = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
(conditions = conditions__build_conditions(record, report));
(pulleys = [...(function* () { for (const item of $iter(records)) { yield drive_build__build_pulley(item, laggings, conditions, report); } })()]);
across_keys__check_width(records, belt_record, report);
(criteria = drive_build__build_criteria(record, report));
(conveyor = null);
if (($in("conveyor", document))) {
([conveyor, cases] = conveyor_build__build_conveyor(record, $bound(criteria, "take_up"), report));
} else {
(cases = drive_file___load_cases(record, records, belt, $bound(criteria, "take_up"), report));
}
drive_build__report_together(belt_record, belt, pulleys, drive__least_tensions(cases), report);
report.raise_all();
(parts = $map([...(function* () { for (const key of $iter(["title", "description", "creep_limit"])) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
return report.sure((() => $call(Drive, [], [["belt", belt], ["pulleys", $b.tuple((function* () { for (const pulley of $iter(pulleys)) { yield pulley; } })())], ["load_cases", conditions__in_each_condition(cases, conditions)], ["criteria", criteria], ["conveyor", conveyor], ...parts])));
}
function source__check_format(document, file = "") {
let given, message, remedy, whole;

if ((!$in("format", document))) {
return null;
}
(given = $at(document, "format"));
(whole = $and($b.isinstance(given, "int"), () => !$truth($b.isinstance(given, "bool"))));
if (($truth(whole) && (1 <= given && given <= 1))) {
return null;
}
if (($truth(whole) && (given > 1))) {
(message = ("" + "the file is of a newer format; this version of wraparc reads up to " + $str(1)));
(remedy = "Update wraparc.");
} else {
([message, remedy] = ["must be a whole number from 1", ("" + "Write format = " + $str(1) + ".")]);
}
throw new InputError(new Problem(message, remedy, file, "format", $shown(given)));
}
function source__read_tables(table, document, file) {
let report;

source__check_format(document, file);
(report = new Report(file));
return [table.read(document, [], report), report];
}
function drive_build__build_belt(record, report) {
let built, layers, more, own, place, preset, published, remedy, sound, sources;

(sources = origins__read_sources(record, (function* () { for (const e of $iter($c1)) { yield e.key; } })(), report));
(own = $or(origins__own_provenance(record, report), () => new Provenance()));
(more = $map([["name", "belt"], ["provenance", own]]));
if (($in("preset", record))) {
(place = [...$iter(record.place), "preset"]);
(preset = report.tried((() => loader__belt($at(record, "preset"))), place, $at(record, "preset")));
if ((preset == null)) {
return null;
}
(more = $map([...(function* () { for (const key of $iter([...$iter($c3), "provenance"])) { yield [key, $b.getattr(preset, key)]; } })()]));
(published = preset.sources);
if (($in("thickness", record))) {
([more, published] = [$map([...more, ["carcass", null]]), $map([])]);
}
(sources = $merged($merged(published, $map([...(function* () { for (const key of $iter($c4)) { if (!(($in(key, record)))) continue; yield [key, own]; } })()])), sources));
} else {
if (((!$in("modulus", record)) && $truth(record.sound("modulus")))) {
(remedy = "Write modulus = \"12960 kN/m\", or choose a belt by preset.");
report.add([...$iter(record.place), "modulus"], "missing", remedy);
return null;
}
}
(more = $map([...(function* () { for (const [key, v] of $iter($m.items(more))) { if (!((($eq(key, "provenance")) || (!$in(key, record))))) continue; yield [key, v]; } })()]));
(built = $method($c5, "built", [record, report], [["sources", sources], ...more]));
if (((built != null) || !$truth(record.sound("width", "modulus")))) {
return built;
}
(sound = new Record($b.dict(record), $bound(record, "place"), $bound(record, "raw")));
(layers = ((!$truth(record.sound()) && $truth(record.sound(...$iter($c6), "thickness"))) ? report : new Report()));
(built = $method($c5, "built", [sound, layers], [["sources", $map([])], ...more]));
$m.pop(sound, "thickness", null);
return $or(built, () => $method($c5, "built", [sound, new Report()], [["sources", $map([])], ...more]));
}
function origins__read_sources(record, keys, report) {
let key, place, provenance, sources, table;

(keys = [...(function* () { for (const key of $iter(keys)) { if (!((!$in(key, ["sources", "provenance", "name", "preset"])))) continue; yield key; } })()]);
(sources = $map([]));
for ([key, table] of $iter($m.items($m.get(record, "sources", $map([]))))) {
if ((!$in(key, keys))) {
(place = [...$iter(record.place), "sources", key]);
report.add(place, "is no key of this table", tables__unknown_key_remedy(key, keys));
} else {
if ($truth($b.isinstance(table, Record))) {
(provenance = origins__read_provenance(table, report));
if ((provenance != null)) {
$put(sources, key, provenance);
}
}
}
}
return sources;
}
function origins__read_provenance(record, report) {
let kind, made;

(kind = (($in("kind", record)) ? $map([["kind", $b.str($at(record, "kind"))]]) : $map([])));
(made = $method($c2, "built", [record, report], [...kind]));
return made;
}
function tables__unknown_key_remedy(key, known) {

return $or(errors__nearest(key, known), () => ("" + "The keys here are " + $str($m.join(", ", known)) + "."));
}
function errors__nearest(given, known) {
let texts;

(texts = [...(function* () { for (const word of $iter(errors__near(given, known))) { yield $shown(word); } })()]);
return ($truth(texts) ? ("" + "Did you mean " + $str($m.join(" or ", texts)) + "?") : "");
}
function errors__near(given, known, most = 3) {
let alike, by_likeness, within, words;

if (!$truth($b.isinstance(given, "str"))) {
return [];
}
(words = $b.list(known));
(within = [...(function* () { for (const word of $iter(words)) { if (!((($b.len(given) > 2) && ($in(given, word))))) continue; yield word; } })()]);
(alike = [...(function* () { for (const word of $iter(words)) { yield [errors___likeness(word, $slice(given, null, 100)), word]; } })()]);
(by_likeness = $b.sorted([...(function* () { for (const pair of $iter(alike)) { if (!(($at(pair, 0) >= 0.55))) continue; yield pair; } })()], $k({reverse: true})));
return $slice($b.list($b.fromkeys($add(within, [...(function* () { for (const [_, word] of $iter($slice(by_likeness, null, most))) { yield word; } })()]))), null, most);
}
function errors___likeness(word, given) {
let size;

(size = $add($b.len(word), $b.len(given)));
return ($truth(size) ? ($mul(2.0, errors___alike(word, given)) / size) : 1.0);
}
function errors___alike(one, other) {
let at, before, first, found, i, j, letter, run, runs, size, there;

([size, at, there] = [0, 0, 0]);
(runs = $mul([0], $add($b.len(other), 1)));
for ([i, letter] of $iter($b.enumerate(one))) {
(before = 0);
for ([j, found] of $iter($b.enumerate(other))) {
(run = (($eq(letter, found)) ? $add(before, 1) : 0));
(before = $at(runs, $add(j, 1)));
$put(runs, $add(j, 1), run);
if ((run > size)) {
([size, at, there] = [run, $sub($add(i, 1), run), $sub($add(j, 1), run)]);
}
}
}
if (($eq(size, 0))) {
return 0;
}
(first = errors___alike($slice(one, null, at), $slice(other, null, there)));
return $add($add(first, size), errors___alike($slice(one, $add(at, size), null), $slice(other, $add(there, size), null)));
}
function origins__own_provenance(record, report) {
let table;

(table = $m.get(record, "provenance"));
return ($truth($b.isinstance(table, Record)) ? origins__read_provenance(table, report) : null);
}
function loader__belt(name) {
let found, wanted;

(wanted = $once(loader___plain, $kept_loader___plain)(name));
(found = $b.next((function* () { for (const b of $iter(belts())) { if (!(($eq($once(loader___plain, $kept_loader___plain)($bound(b, "name")), wanted)))) continue; yield b; } })(), null));
if ((found == null)) {
throw loader__unknown_name("belt", name, (function* () { for (const b of $iter(belts())) { yield b.name; } })(), "wraparc belts");
}
return found;
}
function loader___plain(name) {
return $m.join("", $m.split($m.casefold(name)));
}
const $kept_loader___plain = new Map();
function loader__unknown_name(what, name, known, command) {
let by_plain, remedy, texts;

(by_plain = $map([...(function* () { for (const k of $iter(known)) { yield [$once(loader___plain, $kept_loader___plain)(k), k]; } })()]));
(texts = [...(function* () { for (const key of $iter(errors__near($once(loader___plain, $kept_loader___plain)(name), by_plain))) { yield $shown($at(by_plain, key)); } })()]);
(remedy = ($truth(texts) ? ("" + "Did you mean " + $str($m.join(" or ", texts)) + "?") : ""));
return new InputError(new Problem(("" + "the catalogue has no " + $str(what) + " of this name"), $m.strip(("" + $str(remedy) + " The command `" + $str(command) + "` lists them.")), undefined, undefined, $shown(name)));
}
function conditions__build_conditions(record, report) {
let cases, main, problem, rows;

(rows = [...(function* () { for (const row of $iter($m.get(record, "condition", []))) { if (!((row !== $c7))) continue; yield row; } })()]);
(main = [...(function* () { for (const row of $iter(rows)) { yield [conditions__condition_of(row, report), ["condition"]]; } })()]);
for (problem of $iter(drive__repeated("condition", (function* () { for (const [condition, _] of $iter(main)) { yield condition.name; } })()))) {
report.take(new InputError(problem), []);
}
(cases = [...(function* () { for (const case_ of $iter($or($m.get(record, "load_case"), () => []))) { if (!(($truth($b.isinstance(case_, Record)) && ($in("condition", case_))))) continue; yield [conditions__condition_of($at(case_, "condition"), report), [...$iter(case_.place), "condition"]]; } })()]);
return new Conditions($b.tuple(main), $b.tuple(cases));
}
function conditions__condition_of(value, report) {
let factors, made, source;

if (!$truth($b.isinstance(value, Record))) {
return new Condition($b.str(value));
}
(factors = $m.get(value, "friction_factors", $map([])));
(source = $or(origins__own_provenance(value, report), () => new Provenance()));
(made = $method($c8, "built", [value, report], [["factors", factors], ["source", source]]));
return $or(made, () => new Condition($b.str($m.get(value, "name", "dry"))));
}
function drive__repeated(key, names) {
let found;

(found = $b.list(names));
if (($eq($b.len($b.set(found)), $b.len(found)))) {
return [];
}
return [...(function* () { for (const [name, count] of $iter($m.items($b.Counter(found)))) { if (!((count > 1))) continue; yield new Problem(("" + "used " + $str(count) + " times"), "Give each its own name.", undefined, ("" + $str(key) + ".name"), $shown(name)); } })()];
}
function drive_build__build_pulley(record, laggings, conditions, report) {
let built, by_name, found, found_before, lagging, laws, more, own, place, sources, sure, wrap;

(sources = origins__read_sources(record, (function* () { for (const e of $iter($c9)) { yield e.key; } })(), report));
(laws = []);
if (($in("lagging", record))) {
(laws = laggings.of($at(record, "lagging"), [...$iter(record.place), "lagging"]));
}
if (!$truth(laws)) {
return null;
}
(own = [...(function* () { for (const [c, place] of $iter($slice(conditions.main, null, 1))) { yield [c, place]; } })()]);
if (($in("condition", record))) {
(place = [...$iter(record.place), "condition"]);
(own = [[conditions__condition_of($at(record, "condition"), report), place]]);
}
(found = [...(function* () { for (const [c, place] of $iter([...$iter(own), ...$iter(conditions.several)])) { yield report.tried((() => conditions__at_its_place(c, laws)), place); } })()]);
(sure = [...(function* () { for (const lagging of $iter(found)) { if (!((lagging != null))) continue; yield lagging; } })()]);
if (($b.len(sure) < $b.len(found))) {
return null;
}
(lagging = ($truth(own) ? $at(sure, 0) : $at(laws, 0)));
(by_name = $map([...(function* () { for (const lag of $iter($slice(sure, $b.len(own), null))) { yield [lag.condition, lag]; } })()]));
(more = $map([["conditions", $b.tuple($m.values(by_name))]]));
if (($in("belt_path", record))) {
(wrap = drive_build___wrap_of(record, report));
if ((wrap == null)) {
return null;
}
{ const [$v0, $v1] = [wrap, $map([["wrap_angle", $c27], ...sources])]; $put(more, "wrap_angle", $v0); (sources = $v1); }
}
if (($in("across", record))) {
(found_before = $b.len($bound(report, "problems")));
$put(more, "across", across_keys__build_across($at(record, "across"), report));
if (($b.len($bound(report, "problems")) > found_before)) {
return null;
}
}
(built = $method($c31, "built", [record, report], [["lagging", lagging], ["sources", sources], ...more]));
return built;
}
function conditions__at_its_place(condition, laws) {
let error;

try {
return condition.of(laws);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
throw new InputError((function* () { for (const p of $iter(error.problems)) { yield $replaced(p, new Map([["key", ""], ["value", $shown($bound(condition, "name"))]])); } })());
} else throw $error;
}
}
function drive_build___wrap_of(record, report) {
let own, path, remedy;

(path = $at(record, "belt_path"));
if (($in("wrap_angle", record))) {
(remedy = "Leave one of them out.");
report.add([...$iter(record.place), "wrap_angle"], "belt_path gives it already", remedy);
return null;
}
if ((!$truth($b.isinstance(path, Record)) || !$truth(path.sound()) || (!$in("diameter", record)))) {
return null;
}
function point(given, more = new Map()) {
return $call(Point, [], [...$map([...(function* () { for (const key of $iter($c10)) { if (!(($in(key, given)))) continue; yield [key, $at(given, key)]; } })()]), ...more]);
}
$sig(point, ["given"], true);
(own = $call(point, [path], [["diameter", $at(record, "diameter")]]));
return report.tried((() => belt_path__wrap_angle(point($at(path, "before")), own, point($at(path, "after")))), $bound(path, "place"));
}
function belt_path__wrap_angle(before, pulley, after) {

limits__raise_all(belt_path__overlaps(before, pulley, after));
return belt_path__turned_by(before, pulley, after);
}
function belt_path__overlaps(before, pulley, after) {
let distance, end, key, message, problems, remedy;

(problems = []);
for ([end, key] of $iter([[before, "before"], [after, "after"]])) {
(distance = $math.hypot($sub(end.x, pulley.x), $sub(end.y, pulley.y)));
if (((distance < ($add(end.diameter, pulley.diameter) / 2.0)) || ($eq(distance, 0.0)))) {
(message = ("" + "its centre is only " + $str(display__display(distance, "length")) + " from that of the pulley, and the two overlap"));
(remedy = "Check the coordinates and the diameters.");
$m.append(problems, new Problem(message, remedy, undefined, key));
}
}
return problems;
}
function display__display(value, dimension, system = "si", digits = 4) {

return display__joined(display__parts(value, dimension, system, digits));
}
function display__parts(value, dimension, system, digits) {
let bound, factor, number, other, row, size, unit, zero;

(row = $once(display__unit_row, $kept_display__unit_row)(dimension, system));
([unit, number] = [row.unit, (value / row.factor)]);
if ((($b.abs(number) < 1e-09) && (!$eq(dimension, "wear_coefficient")))) {
(number = 0.0);
}
(size = $b.abs(digits__read(digits__rounded(number, digits))));
for ([bound, other, factor, zero] of $iter(row.larger)) {
if ((bound <= size && size < Infinity)) {
([unit, number] = [other, ($sub(value, zero) / factor)]);
}
}
return [digits__rounded(number, digits), unit];
}
function display__unit_row(dimension, system) {
let larger, more, one, unit, zero;

([unit, more] = $at($at($c11, system), dimension));
if (($eq(dimension, "temperature"))) {
(zero = parse__parse_quantity(("" + "0 " + $str(unit)), dimension));
(one = parse__parse_quantity(("" + "1 " + $str(unit)), dimension));
return new UnitRow("K", 1.0, [[0.0, unit, $sub(one, zero), zero]]);
}
(larger = $b.tuple((function* () { for (const [bound, name] of $iter(more)) { yield [bound, name, parse__unit_factor(name, dimension), 0.0]; } })()));
return new UnitRow(unit, parse__unit_factor(unit, dimension), larger);
}
const $kept_display__unit_row = new Map();
function parse__parse_quantity(value, dimension) {
let kind, problem;

(kind = $at($c12, dimension));
if (($truth($b.isinstance(value, "int", "float")) && !$truth($b.isinstance(value, "bool")))) {
if (($eq(dimension, "number"))) {
return numbers__finite(value, value);
}
throw parse___no_unit(value, dimension);
}
if (!$truth($b.isinstance(value, "str"))) {
(problem = ("" + "neither text nor a number, where " + $str(kind.name) + " is needed"));
throw parse___refused(value, problem, ("" + "Write for example " + $str($shown($bound(kind, "example"))) + "."));
}
return $once(parse___read, $kept_parse___read)(value, dimension);
}
function numbers__finite(number, given) {
let value;

try {
(value = $b.float(number));
} catch ($error) {
if ($error instanceof $OverflowError) {
(value = Infinity);
} else throw $error;
}
if (!$truth($math.isfinite(value))) {
throw numbers___refused(given, "not a finite number", "Give the size that was measured or meant.");
}
if ((($eq(value, 0)) && (!$eq(number, 0)))) {
throw numbers___refused(given, "too small to tell from zero", "Write 0, or check the exponent.");
}
return value;
}
function numbers___refused(given, message, remedy) {
return new InputError(new Problem(message, remedy, undefined, undefined, $shown(given)));
}
function parse___no_unit(value, dimension) {
let kind, message;
(kind = $at($c12, dimension));
(message = ("" + "no unit, where " + $str(kind.name) + " is needed"));
return parse___refused(value, message, ("" + "Write the unit too, for example " + $str($shown($bound(kind, "example"))) + "."));
}
function parse___refused(given, message, remedy) {
return new InputError(new Problem(message, remedy, undefined, undefined, $shown(given)));
}
function parse___read(text, dimension) {
let number, unit, unit_text;
([number, unit_text] = numbers__split_number(text));
if ((!$truth(unit_text) && (!$eq(dimension, "number")))) {
throw parse___no_unit(text, dimension);
}
(unit = parse___checked_unit(unit_text, dimension, text));
return numbers__finite($mul($sub(number, unit.zero), unit.factor), text);
}
const $kept_parse___read = new Map();
function numbers__split_number(text) {
let inverse_unit, match, rest, stripped;

if (($b.len(text) > 80)) {
throw numbers___refused(text, ("" + "longer than " + $str(80) + " characters"), "Shorten it.");
}
(stripped = $m.strip(text));
(match = $m.match($c13, stripped));
if ((match == null)) {
throw numbers___malformed(text, stripped);
}
(rest = $m.strip($slice(stripped, $m.end(match), null)));
(inverse_unit = $and(($m.end(match) < $b.len(stripped)), () => $m.match($c19, rest)));
if (($truth(rest) && ($truth($m.match($c20, rest)) || $truth($m.isdecimal($at(rest, 0)))) && !$truth(inverse_unit))) {
throw numbers___malformed(text, stripped);
}
return [numbers___decimal($m.group(match), text), rest];
}
function numbers___malformed(text, stripped) {
let digits, head, message, rest;

(head = $m.match($c14, stripped));
(digits = ($truth(head) ? $m.strip($m.group(head)) : ""));
(rest = ($truth(head) ? $m.strip($slice(stripped, $b.len($m.group(head)), null)) : ""));
if (!$truth(stripped)) {
return numbers___refused(text, "empty, where a number is needed", "Write a number.");
}
if ($truth($m.match($c15, stripped))) {
return numbers___refused(text, "not a finite number", "Give the size that was measured or meant.");
}
if ($truth($b.any((function* () { for (const c of $iter(stripped)) { yield $and($m.isdecimal(c), () => !$truth($m.isascii(c))); } })()))) {
return numbers___refused(text, "digits other than 0-9", "Use the digits 0-9, a point for decimals, and nothing between thousands.");
}
if (($in(",", digits))) {
(message = "a comma can mean a decimal point or a thousands separator");
return numbers___refused(text, message, numbers___write(numbers___comma_readings(digits), rest));
}
if (($truth($m.search($c17, digits)) && (!$in("/", digits)))) {
(message = "digits in groups can be read as one number or as several");
return numbers___refused(text, message, numbers___write([$m.sub($c17, "", digits)], rest));
}
if (($in("/", digits))) {
return numbers___refused(text, "a fraction, where a decimal number is needed", "Use the digits 0-9, a point for decimals, and nothing between thousands.");
}
if (($in("−", digits))) {
return numbers___refused(text, "a typographic minus sign", "Use the plain hyphen-minus '-'.");
}
return numbers___refused(text, "does not begin with one plain number", "Use the digits 0-9, a point for decimals, and nothing between thousands.");
}
function numbers___comma_readings(digits) {
let _, bare_whole, decimal, decimals, exponent, joined, power, readings, whole;

(exponent = $m.search($c16, digits));
(power = ($truth(exponent) ? $m.group(exponent) : ""));
(joined = $m.sub($c17, "", $m.removesuffix(digits, power)));
([whole, _, decimals] = $m.rpartition(joined, ","));
(bare_whole = $m.sub($c18, "", whole));
(readings = [$m.replace(joined, ",", "")]);
if (((!$in(",", whole)) && (!$in(".", decimals)))) {
(decimal = ("" + $str(bare_whole) + "." + $str(decimals)));
(readings = ((($in(".", whole)) || (!$eq($b.len(decimals), 3))) ? [decimal] : [...$iter(readings), decimal]));
}
return [...(function* () { for (const reading of $iter(readings)) { yield $add(reading, power); } })()];
}
function numbers___write(readings, rest) {
if (!$truth($b.all((function* () { for (const reading of $iter(readings)) { yield $m.fullmatch($c13, reading); } })()))) {
return "Use the digits 0-9, a point for decimals, and nothing between thousands.";
}
return $add($add("Write ", $m.join(" or ", (function* () { for (const r of $iter(readings)) { yield $shown($m.strip(("" + $str(r) + " " + $str(rest)))); } })())), ".");
}
function numbers___decimal(digits, given) {
let exponent;
(exponent = $m.search($c16, digits));
if (((exponent != null) && ($b.len($m.lstrip($m.group(exponent, 1), "0")) > 4))) {
throw numbers___refused(given, "its exponent is out of range", "Check the exponent.");
}
return $b.Decimal(digits);
}
function parse___checked_unit(text, dimension, given) {
let error, found, kind, measured, message, unit;
(kind = $at($c12, dimension));
try {
(unit = $once(parse___resolve, $kept_parse___resolve)(text));
} catch ($error) {
if ($error instanceof _UnitTextError) {
error = $error;
throw parse___refused(given, $b.str(error), $bound(error, "remedy"));
} else throw $error;
}
if ((!$eq(unit.powers, $once(parse___powers, $kept_parse___powers)(dimension)))) {
(measured = parse__dimension_of(text));
(found = ($truth(measured) ? $at($c12, measured).name : "of no dimension used here"));
(message = ("" + $str(found) + ", where " + $str(kind.name) + " is needed"));
throw parse___refused(given, message, ("" + "Write for example " + $str($shown($bound(kind, "example"))) + "."));
}
return unit;
}
function parse___resolve(text) {
return parse___evaluate(text, $once(parse___units, $kept_parse___units)());
}
const $kept_parse___resolve = new Map();
function parse___units() {
let definition, known, of, size, unit;

(size = $b.len($c21));
(known = $map([...(function* () { for (const [i, name] of $iter($b.enumerate($c21))) { yield [name, new Unit($b.Decimal(1), $b.tuple((function* () { for (const j of $iter($b.range(size))) { yield $b.int(($eq(i, j))); } })()))]; } })()]));
for (definition of $iter($c22)) {
(of = parse___evaluate($bound(definition, "unit"), known));
(unit = new Unit($mul(definition.factor, of.factor), $bound(of, "powers"), $bound(definition, "zero")));
$m.update(known, $b.fromkeys(definition.names, unit));
}
return known;
}
const $kept_parse___units = new Map();
function parse___evaluate(text, known) {
let factors, match, message, name, over, plain, power, powers, product, under, unit;
(plain = $m.replace($m.strip($m.translate(text, $c23)), "**", "^"));
if (($in(plain, known))) {
return $at(known, plain);
}
(match = (($b.len(plain) <= 40) ? $m.fullmatch($c24, plain) : null));
if ((match == null)) {
throw new _UnitTextError(("" + "the unit " + $str($shown(text)) + " cannot be read"), "Write a product of units with at most one '/', a product below it in brackets: \"kN/m\", \"N m\", \"mm3/(N m)\".");
}
([over, under] = [$or($at(match, "over"), () => ""), $or($at(match, "one"), () => $or($at(match, "under"), () => ""))]);
(factors = [...(function* () { for (const [name, power] of $iter($m.findall($c25, over))) { yield [name, $b.int($or(power, () => 1))]; } })()]);
(factors = $add(factors, [...(function* () { for (const [name, power] of $iter($m.findall($c25, under))) { yield [name, $neg($b.int($or(power, () => 1)))]; } })()]));
if ((($eq($b.len(factors), 1)) && ($eq($at($at(factors, 0), 1), 1)))) {
return parse___named($at($at(factors, 0), 0), known);
}
(product = new Unit($b.Decimal(1), $mul([0], $b.len($c21))));
for ([name, power] of $iter(factors)) {
(unit = parse___named(name, known));
if ($truth(unit.zero)) {
(message = ("" + $str(name) + " cannot be part of a compound unit: its zero is not 0 K"));
throw new _UnitTextError(message, "Use K.");
}
(powers = $b.tuple((function* () { for (const [a, b] of $iter($b.zip($bound(product, "powers"), $bound(unit, "powers"), $k({strict: true})))) { yield $add(a, $mul(power, b)); } })()));
(product = new Unit($mul(product.factor, $pow(unit.factor, power)), powers));
}
return product;
}
function parse___named(name, known) {
let meant, remedy, same_but_case, unit;
(unit = $m.get(known, name));
if ((unit != null)) {
return unit;
}
(same_but_case = [...(function* () { for (const other of $iter(known)) { if (!(($eq($m.casefold(other), $m.casefold(name))))) continue; yield other; } })()]);
(meant = $or(same_but_case, () => errors__near(name, known, 2)));
(remedy = "The units are listed in the documentation; case matters.");
if ($truth(meant)) {
(remedy = $add($add("Did you mean ", $m.join(" or ", meant)), "?"));
}
throw new _UnitTextError(("" + "unknown unit " + $str($shown(name))), remedy);
}
function parse___powers(dimension) {
return $once(parse___resolve, $kept_parse___resolve)($bound($at($c12, dimension), "si_unit")).powers;
}
const $kept_parse___powers = new Map();
function parse__dimension_of(unit) {
let powers;

try {
(powers = $once(parse___resolve, $kept_parse___resolve)(unit).powers);
} catch ($error) {
if ($error instanceof _UnitTextError) {
return null;
} else throw $error;
}
if ((($in("J", unit)) && ($eq(powers, $once(parse___powers, $kept_parse___powers)("energy_per_area"))))) {
return "energy_per_area";
}
return $b.next((function* () { for (const name of $iter($c26)) { if (!(($eq($once(parse___powers, $kept_parse___powers)(name), powers)))) continue; yield name; } })(), null);
}
function parse__unit_factor(unit, dimension) {
let resolved;

(resolved = parse___checked_unit(unit, dimension, unit));
if ($truth(resolved.zero)) {
throw parse___refused(unit, "has its zero elsewhere than 0 K", "Convert the column to K.");
}
return $b.float($bound(resolved, "factor"));
}
function digits__rounded(number, digits) {
let given, power, text;

if ($truth($math.isnan(number))) {
return "nan";
}
if ($truth($math.isinf(number))) {
return ((number > 0.0) ? "inf" : "-inf");
}
if (($eq(number, 0.0))) {
return "0";
}
(given = digits__scientific(number, $sub(4, 1)));
(power = digits__exponent_of(given));
if (((digits <= 4) && $truth(digits___equal(digits__read(given), number)) && ($neg(4) <= power && power < 12))) {
return digits__trimmed(digits__fixed(digits__read(given), $b.max(0, $sub($sub(4, 1), power))));
}
(text = digits__scientific(number, $sub(digits, 1)));
(power = digits__exponent_of(text));
return (($neg(4) <= power && power < 12) ? digits__fixed(digits__read(text), $b.max(0, $sub($sub(digits, 1), power))) : text);
}
function digits__scientific(number, digits) {

return ("" + $format(number, ("" + "." + $str(digits) + "e")));
}
function digits__exponent_of(text) {

return $b.int($at($m.rpartition(text, "e"), 2));
}
function digits__read(text) {

return $b.float(text);
}
function digits___equal(a, b) {
return ($b.abs($sub(a, b)) <= $mul(1e-09, $b.max($b.abs(a), $b.abs(b))));
}
function digits__fixed(number, digits) {

return ("" + $format(number, ("" + "." + $str(digits) + "f")));
}
function digits__trimmed(text) {

return (($in(".", text)) ? $m.rstrip($m.rstrip(text, "0"), ".") : text);
}
function display__joined(of) {
let number, unit;

([number, unit] = of);
return $add(number, ((!$eq(unit, "")) ? $add(" ", unit) : ""));
}
function limits__raise_all(problems) {

if ($truth(problems)) {
throw new InputError(problems);
}
}
function belt_path__turned_by(before, pulley, after) {
let incoming, outgoing, turned;

([incoming, outgoing] = [belt_path___direction(before, pulley), belt_path___direction(pulley, after)]);
(turned = (($eq(pulley.turn, "counterclockwise")) ? $sub(outgoing, incoming) : $sub(incoming, outgoing)));
(turned = (turned % 6.283185307179586));
return (($sub(6.283185307179586, turned) < 1e-09) ? 0.0 : turned);
}
function belt_path___direction(start, end) {
let dx, dy, offset;

([dx, dy] = [$sub(end.x, start.x), $sub(end.y, start.y)]);
(offset = $sub(end.side, start.side));
return $sub($math.atan2(dy, dx), $math.asin((offset / $math.hypot(dx, dy))));
}
function across_keys__build_across(record, report) {
let built, ends;

if (!$truth($b.isinstance(record, Record))) {
return null;
}
(ends = $map([...(function* () { for (const [key, kind] of $iter([["before", $c28], ["after", $c29]])) { if (!($truth($b.isinstance($m.get(record, key), Record)))) continue; yield [key, kind.built($at(record, key), report)]; } })()]));
(built = $method($c30, "built", [record, report], [...ends]));
return built;
}
function across_keys__check_width(pulleys, belt, report) {
let across, key, problem, profile, pulley;

if ((!$truth($b.isinstance(belt, Record)) || (!$in("width", belt)))) {
return null;
}
for (pulley of $iter(pulleys)) {
(across = $m.get(pulley, "across"));
if (!$truth($b.isinstance(across, Record))) {
continue;
}
for ([key, profile] of $iter($m.items(across))) {
if ($truth($b.isinstance(profile, WidthProfile))) {
for (problem of $iter(profile.problems("", $at(belt, "width")))) {
report.take(new InputError(problem), [...$iter(across.place), key]);
}
}
}
}
}
function drive_build__build_criteria(record, report) {
let parts;

(parts = $map([...(function* () { for (const e of $iter($c32)) { yield [e.attribute, e.kind.built($m.get(record, $bound(e, "key")), report)]; } })()]));
return $call(Criteria, [], [...$map([...(function* () { for (const [name, part] of $iter($m.items(parts))) { if (!((part != null))) continue; yield [name, part]; } })()])]);
}
function drive_file___load_cases(record, pulleys, built_belt, take_up, report) {
let belt, built, case_, cases, given, more, names, own, problem, speed, sure, tensions, whole;

(belt = $m.get(record, "belt"));
(names = [...(function* () { for (const item of $iter(pulleys)) { if (!(($in("name", item)))) continue; yield $at(item, "name"); } })()]);
(cases = [...(function* () { for (const item of $iter($or($m.get(record, "load_case"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
for (problem of $iter(drive__repeated("pulley", names))) {
report.take(new InputError(problem), []);
}
if ((($b.len($b.set(names)) < $b.len($or($m.get(record, "pulley"), () => []))) || !$truth($b.isinstance(belt, Record)))) {
return [];
}
(sure = $and(belt.sound("speed"), () => $b.all((function* () { for (const item of $iter(pulleys)) { yield item.sound(...$iter($c33)); } })())));
(speed = $m.get(belt, "speed"));
(own = [...(function* () { for (const item of $iter(pulleys)) { yield Given.of($at(item, "name"), item, drive_file___pulled_at(item, built_belt)); } })()]);
(built = []);
if ((!$truth(cases) || $truth(tensions__complete(own, speed)))) {
(tensions = tensions__resolve(own, speed, report, sure));
$m.append(built, new LoadCase("design", tensions));
}
for (case_ of $iter(cases)) {
if (($in("train", case_))) {
report.add([...$iter(case_.place), "train"], "there is no [train] table", "Write one.");
}
(given = drive_file___of_case(case_, own, take_up, speed, report));
(whole = $and(sure, () => case_.sound()));
(tensions = tensions__resolve(given, speed, report, whole));
if (($in("name", case_))) {
(more = $map([["kind", $m.get(case_, "kind", "running")], ["condition", conditions__condition_name(case_)]]));
$m.append(built, $call(LoadCase, [], [["name", $at(case_, "name")], ["tensions", tensions], ...more]));
}
}
for (problem of $iter(drive__repeated("load_case", (function* () { for (const case_ of $iter(built)) { yield case_.name; } })()))) {
report.take(new InputError(problem), []);
}
return $b.tuple(built);
}
function drive_file___pulled_at(pulley, belt) {
let diameter;

(diameter = $m.get(pulley, "diameter"));
if (((diameter == null) || (belt == null))) {
return diameter;
}
return $add(diameter, $mul(2.0, $or(pitch__pitch_offset(belt, $m.get(pulley, "side", "pulley")), () => 0.0)));
}
function pitch__pitch_offset(belt, side) {
let found;

(found = pitch__tension_offset(pitch__layers_of(belt), ($eq(side, "carry"))));
return ($truth($math.isnan(found)) ? null : found);
}
function pitch__layers_of(belt) {
let given;

(given = [belt.pulley_cover, belt.carry_cover, belt.carcass, belt.thickness]);
return pitch__layers(...$iter((function* () { for (const value of $iter(given)) { yield ((value == null) ? NaN : value); } })()));
}
function pitch__layers(pulley_cover, carry_cover, carcass, thickness) {
let known;

(known = ($eq(thickness, thickness)));
if (($truth(known) && $truth($math.isnan(carcass)))) {
return new Layers(pulley_cover, carry_cover, $sub($sub(thickness, pulley_cover), carry_cover));
}
if (($truth(known) && $truth($math.isnan(carry_cover)))) {
return new Layers(pulley_cover, $sub($sub(thickness, pulley_cover), carcass), carcass);
}
if (($truth(known) && $truth($math.isnan(pulley_cover)))) {
return new Layers($sub($sub(thickness, carry_cover), carcass), carry_cover, carcass);
}
return new Layers(pulley_cover, carry_cover, carcass);
}
function pitch__tension_offset(of, carries) {

return $add(pitch__touching_cover(of, carries), $mul(0.5, of.carcass));
}
function pitch__touching_cover(of, carries) {

return ($truth(carries) ? of.carry_cover : of.pulley_cover);
}
function tensions__complete(given, speed) {

return $b.all((function* () { for (const pair of $iter(tensions__spread(given, speed))) { yield (!$in(null, pair)); } })());
}
function tensions__spread(given, speed) {
let _, entry, i, leaving, pairs, pull, pulls;

(pairs = [...(function* () { for (const item of $iter(given)) { yield new NipTensions($bound(item.values, "entry_tension"), $bound(item.values, "exit_tension")); } })()]);
(pulls = [...(function* () { for (const item of $iter(given)) { yield tension_rules__pull_given($bound(item, "values"), item.at(speed)); } })()]);
for (_ of $iter($b.range($mul(2, $b.len(pairs))))) {
for ([i, pull] of $iter($b.enumerate(pulls))) {
([entry, leaving] = tension_rules__filled(...$iter($at(pairs, i)), pull));
if (((entry == null) && (i > 0))) {
([entry, leaving] = tension_rules__filled($bound($at(pairs, $sub(i, 1)), "exit"), leaving, pull));
}
if (((leaving == null) && ($add(i, 1) < $b.len(pairs)))) {
([entry, leaving] = tension_rules__filled(entry, $bound($at(pairs, $add(i, 1)), "entry"), pull));
}
$put(pairs, i, new NipTensions(entry, leaving));
}
}
return pairs;
}
function tensions__resolve(given, speed, report, sure = true) {
let entry, exit_, fault, item, made, place, tensions, wrong;

(wrong = [...(function* () { for (const item of $iter(given)) { yield tensions___wrong(item, speed, report); } })()]);
if ($truth($b.any(wrong))) {
return $map([]);
}
for (item of $iter(($truth(sure) ? given : []))) {
(fault = tension_rules__speed_missing($bound(item, "values"), item.at(speed)));
if ($truth(fault)) {
(place = (($in(fault.lacks, item.inherited)) ? item.place : [...$iter(item.place), fault.lacks]));
report.add(place, $bound(fault, "message"), $bound(fault, "remedy"));
(sure = false);
}
}
if ($truth($b.any((function* () { for (const item of $iter(given)) { yield $and((item.diameter == null), () => (item.values.torque != null)); } })()))) {
(sure = false);
}
(tensions = $map([]));
for ([item, [entry, exit_]] of $iter($b.zip(given, tensions__spread(given, speed), $k({strict: true})))) {
if (((entry == null) || (exit_ == null))) {
if ($truth(sure)) {
(fault = tension_rules__too_few($bound(item, "values")));
report.add($bound(item, "place"), $bound(fault, "message"), $bound(fault, "remedy"));
}
} else {
if ($truth((made = tensions___made(item, entry, exit_, report)))) {
$put(tensions, item.name, made);
}
}
}
return tensions;
}
function tensions___wrong(item, speed, report) {
let fault;

(fault = tension_rules__fault_of($bound(item, "values"), $b.bool($bound(item, "inherited")), item.at(speed), tensions___force));
if ($truth(fault)) {
report.add($bound(item, "place"), $bound(fault, "message"), $bound(fault, "remedy"));
}
return fault;
}
function tensions___force(value) {
return display__display(value, "force");
}
function tensions___made(item, entry, exit_, report) {
let key, made, message, place, pulls, remedy, side, tension, told, what, why;
(pulls = tension_rules__effective_keys($bound(item, "values")));
try {
(told = $m.join(" and ", (function* () { for (const key of $iter(pulls)) { yield $m.strip(("" + $str($m.replace(key, "_", " ")) + " " + $str($m.get(item.raw, key, "")))); } })()));
(why = ($truth(told) ? ("" + "computed from " + $str(told)) : "that of the neighbouring pulley"));
(made = $map([...(function* () { for (const [key, name] of $iter($m.items($c34))) { if (!(($b.getattr($bound(item, "values"), name) == null))) continue; yield [key, why]; } })()]));
return new Tensions(entry, exit_, made);
} catch ($error) {
if ($error instanceof InputError) {
([side, tension] = ((exit_ <= 0.0) ? ["exit", exit_] : ["entry", entry]));
(key = $b.next((function* () { for (const k of $iter(pulls)) { if (!((!$in(k, item.inherited)))) continue; yield k; } })(), ""));
(place = ($truth(key) ? [...$iter(item.place), key] : item.place));
(what = ((tension <= 0.0) ? "a belt cannot push" : "no belt carries that"));
(message = ("" + "leaves an " + $str(side) + " tension of " + $str(display__display(tension, "force")) + ", and " + $str(what)));
(remedy = "Give a smaller pull or a larger tension on the slack side.");
report.add(place, message, remedy, ...$iter(($truth(key) ? [$at(item.raw, key)] : [])));
return null;
} else throw $error;
}
}
function drive_file___of_case(case_, own, take_up, speed, report) {
let given, item, name, names, over, place, remedy, table, tables, there;

(tables = $m.get(case_, "pulley", $map([])));
(names = [...(function* () { for (const item of $iter(own)) { yield item.name; } })()]);
for (name of $iter(tables)) {
if ((!$in(name, names))) {
(there = $m.join(", ", (function* () { for (const name of $iter(names)) { yield $shown(name); } })()));
(remedy = $or(errors__nearest(name, names), () => ("" + "The pulleys are " + $str(there) + ".")));
report.add([...$iter(case_.place), "pulley", name], "no such pulley", remedy);
}
}
(given = []);
for (item of $iter(own)) {
(table = $m.get(tables, $bound(item, "name")));
(place = [...$iter(case_.place), "pulley", item.name]);
(over = ($truth($b.isinstance(table, Record)) ? table : new Record($map([]), place, $map([]))));
$m.append(given, $method(item, "overridden", [over], [["fixed", take_up.fixed], ["speed", speed]]));
}
return given;
}
function conditions__condition_name(case_) {
let value;

(value = $m.get(case_, "condition", ""));
return ($truth($b.isinstance(value, Record)) ? $b.str($m.get(value, "name", "")) : $b.str(value));
}
function conveyor_build__build_conveyor(record, take_up, report) {
let conveyor, given, message, pulleys, remedy, states;

(pulleys = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
conveyor_build___refuse_tensions(record, pulleys, report);
if ($truth(take_up.fixed)) {
(message = "a fixed take-up holds another tension in every load case, and [conveyor] has one");
(remedy = "Give the tensions of each load case instead of [conveyor].");
report.add(["take_up", "kind"], message, remedy, $bound(take_up, "kind"));
}
if (($b.len($or($m.get(record, "pulley"), () => [])) > 1)) {
(message = ("" + "gives the tensions of one drive pulley, and there are " + $str($b.len($at(record, "pulley")))));
report.add(["conveyor"], message, "Put the tensions of a train into [train].");
}
(given = $m.get(record, "conveyor"));
if (!$truth($b.isinstance(given, Record))) {
return [null, []];
}
if ($truth(take_up.after)) {
(message = "the [conveyor] table says where its take-up stands, take_up_distance");
report.add(["take_up", "after"], message, "Leave it out.", $bound(take_up, "after"));
}
(conveyor = conveyor_build___conveyor(given, $m.get(record, "belt"), take_up, report));
(states = $and(conveyor, () => report.tried($bound(conveyor, "states"), $bound(given, "place"), $bound(given, "raw"))));
if ((!$truth(states) || !$truth(pulleys) || (!$in("name", $at(pulleys, 0))))) {
return [conveyor, []];
}
return [conveyor, $b.tuple((function* () { for (const state of $iter(states)) { yield conveyor_build__load_case(state, $at($at(pulleys, 0), "name")); } })())];
}
function conveyor_build___refuse_tensions(record, pulleys, report) {
let key, pulley;

for (pulley of $iter(pulleys)) {
for (key of $iter((function* () { for (const key of $iter($c33)) { if (!(($in(key, pulley)))) continue; yield key; } })())) {
report.add([...$iter(pulley.place), key], "the [conveyor] table gives the tensions already", "Leave it out, or the [conveyor] table.", $at(pulley.raw, key));
}
}
if (($in("load_case", record))) {
report.add(["load_case"], "the [conveyor] table gives the load cases already", "Leave it out, or the [conveyor] table.");
}
}
function conveyor_build___conveyor(given, belt, take_up, report) {
let conveyor, more, speed, told, unsure;
(more = $map([["sheave_ratio", take_up.sheave_ratio]]));
(speed = ($truth($b.isinstance(belt, Record)) ? $m.get(belt, "speed") : null));
if ((speed != null)) {
$put(more, "speed", speed);
}
if ($truth(given.sound())) {
(conveyor = $method($c35, "built", [given, report], [...more]));
return conveyor;
}
(unsure = $or(!$truth($b.isinstance(belt, Record)), () => !$truth(belt.sound("speed"))));
(told = conveyor__choices(new Set([...$iter(given), ...$iter(given.faulty), ...$iter(more), ...$iter(($truth(unsure) ? ["speed"] : []))])));
if ($truth(told)) {
report.take(new InputError(told), $bound(given, "place"), $bound(given, "raw"));
}
return null;
}
function conveyor__choices(given) {
let example, first, key, message, problems, remedy, second;

(problems = []);
for ([first, second, example] of $iter($c36)) {
if ((($in(first, given)) && ($in(second, given)))) {
(message = ("" + $str(first) + " and " + $str(second) + " both say the same"));
$m.append(problems, new Problem(message, "Leave one of them out.", undefined, second));
} else {
if (((!$eq(example, "")) && (!$in(first, given)) && (!$in(second, given)))) {
(remedy = ("" + "Write " + $str(example) + ", or " + $str(second) + "."));
$m.append(problems, new Problem("missing", remedy, undefined, first));
}
}
}
for (key of $iter($c37)) {
if ((($in(key, given)) && (!$in("speed", given)))) {
(remedy = "Write speed = \"3 m/s\" in [belt].");
$m.append(problems, new Problem("needs the belt speed", remedy, undefined, key));
}
}
return problems;
}
function conveyor_build__load_case(state, pulley) {
let kind, made, tensions, why;

(why = "computed from the resistances of the conveyor");
(made = $map([["entry", why], ["exit", why]]));
(tensions = new Tensions(state.entry, state.exit, made));
(kind = state.kind);
return new LoadCase(state.name, $map([[pulley, tensions]]), kind);
}
function drive__least_tensions(cases) {

return $map([...(function* () { for (const case_ of $iter(cases)) { yield [("" + "load_case." + $str(case_.name)), $b.min((function* () { for (const t of $iter($m.values(case_.tensions))) { yield $b.min($bound(t, "entry"), $bound(t, "exit")); } })(), $k({default: Infinity}))]; } })()]);
}
function drive_build__report_together(record, belt, pulleys, tensions, report) {
let found;

if ((!$truth(report.problems) || (belt == null) || !$truth($b.isinstance(record, Record)))) {
return null;
}
(found = [...(function* () { for (const [key, least] of $iter($m.items(tensions))) { for (const p of $iter(drive__flying_problems(belt, key, least))) { yield p; }} })()]);
if ($truth(record.sound(...$iter($c6), "thickness"))) {
(found = $add(found, drive__side_problems(belt, [...(function* () { for (const pulley of $iter(pulleys)) { if (!((pulley != null))) continue; yield pulley; } })()])));
}
if ($truth(found)) {
report.take(new InputError(found), []);
}
}
function drive__flying_problems(belt, key, least) {
let force;

(force = pitch__centrifugal_of(belt));
if ((force < least)) {
return [];
}
return [new Problem(("" + "the belt presses on no pulley: m v^2 = " + $str(display__display(force, "force")) + ", with a mass of " + $str(display__display($or(belt.mass, () => 0.0), "mass_per_length")) + ", and its least tension is " + $str(display__display(least, "force"))), "Give the mass of a metre of belt, not that of the whole belt.", undefined, key)];
}
function pitch__centrifugal_of(belt) {

if (((belt.mass == null) || (belt.speed == null))) {
return 0.0;
}
return pitch__centrifugal_force($bound(belt, "mass"), $bound(belt, "speed"));
}
function drive__side_problems(belt, pulleys) {

if ($truth($b.all((function* () { for (const key of $iter([...$iter($c6), "thickness"])) { yield ($b.getattr(belt, key) == null); } })()))) {
return [];
}
return [...(function* () { for (const pulley of $iter(pulleys)) { if (!((($eq(pulley.side, "carry")) && $truth($math.isnan(pitch__touching_cover(pitch__layers_of(belt), true)))))) continue; yield new Problem("the pulley meets the carry side, and carry_cover of the belt is not given", "Give carry_cover = \"5 mm\" in [belt], or thickness with the other layers.", undefined, ("" + "pulley." + $str(pulley.name) + ".side"), $shown($bound(pulley, "side"))); } })()];
}
function conditions__in_each_condition(cases, conditions) {
let case_, found, names, split;

(names = [...(function* () { for (const [condition, _] of $iter(conditions.main)) { yield condition.name; } })()]);
if (($b.len(names) < 2)) {
return $b.tuple(cases);
}
(found = []);
for (case_ of $iter(cases)) {
(split = [...(function* () { for (const name of $iter(names)) { yield $replaced(case_, new Map([["name", ("" + $str(case_.name) + ", " + $str(name))], ["condition", name]])); } })()]);
(found = $add(found, ($truth(case_.condition) ? [case_] : split)));
}
return $b.tuple(found);
}
function file__train_from_document(document, file = "", folder = "", overrides = [], allow_paths = false) {
let belt, belt_record, cases, conditions, criteria, drive, ends, error, known, laggings, message, own, parts, problem, pulleys, reader, record, records, report, told, train;

(document = overridden(document, overrides, file));
if ((!$in("train", document))) {
(drive = drive_file__drive_from_document(document, file, folder, undefined, allow_paths));
return Train.of(drive);
}
([record, report] = source__read_tables($c38, document, file));
(belt_record = $m.get(record, "belt"));
(belt = ($truth($b.isinstance(belt_record, Record)) ? drive_build__build_belt(belt_record, report) : null));
(own = $m.get(record, "lagging"));
(laggings = new Laggings(($truth($b.isinstance(own, "dict")) ? own : $map([])), folder, allow_paths, report));
(records = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
(conditions = conditions__build_conditions(record, report));
(pulleys = [...(function* () { for (const item of $iter(records)) { yield drive_build__build_pulley(item, laggings, conditions, report); } })()]);
file___refuse_pulley_tensions(record, records, report);
if (($in("conveyor", record))) {
(message = "gives the tensions of one drive, and those of a train stand in [train]");
report.add(["conveyor"], message, "Leave one of them out.");
}
(criteria = drive_build__build_criteria(record, report));
(train = $m.get(record, "train"));
(ends = ($truth($b.isinstance(train, Record)) ? [...(function* () { for (const key of $iter(["entry_tension", "exit_tension"])) { if (!(($in(key, train)))) continue; yield $at(train, key); } })()] : []));
drive_build__report_together(belt_record, belt, pulleys, ($truth(ends) ? $map([["train", $b.min(ends)]]) : $map([])), report);
report.raise_all();
(known = [belt, [...(function* () { for (const p of $iter(pulleys)) { yield p; } })()]]);
(reader = new Reader(record, ...$iter(known), report, $bound(criteria, "take_up")));
(parts = $map([...(function* () { for (const key of $iter(["title", "description", "creep_limit"])) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
(cases = reader.cases());
report.raise_all();
try {
return $call(Train, [], [["belt", reader.belt], ["pulleys", reader.actual], ["cases", conditions__in_each_condition(cases, conditions)], ["criteria", criteria], ["nominal_diameters", ((!$eq(reader.actual, $b.tuple($bound(reader, "pulleys")))) ? reader.nominal : [])], ...parts]);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(told = $map([]));
for (problem of $iter(error.problems)) {
$m.setdefault(told, [problem.message, problem.value], file___placed(problem, cases, file));
}
throw new InputError($m.values(told));
} else throw $error;
}
}
function file___refuse_pulley_tensions(record, pulleys, report) {
let case_, key, message, pulley, remedy;

(message = "the tensions of single pulleys follow from [train]");
for (pulley of $iter(pulleys)) {
for (key of $iter((function* () { for (const key of $iter($c33)) { if (!(($in(key, pulley)))) continue; yield key; } })())) {
report.add([...$iter(pulley.place), key], message, "Leave it out.", $at(pulley.raw, key));
}
}
for (case_ of $iter($or($m.get(record, "load_case"), () => []))) {
if (($truth($b.isinstance(case_, Record)) && ($in("pulley", case_)))) {
(remedy = "Write a [load_case.train] table.");
report.add([...$iter(case_.place), "pulley"], message, remedy);
}
}
}
function file___placed(problem, cases, file) {
let case_, own, prefix, rest;

for (case_ of $iter(cases)) {
(prefix = ("" + "load_case." + $str(case_.name) + "."));
if ($truth($m.startswith(problem.key, prefix))) {
(rest = $m.removeprefix(problem.key, prefix));
(own = (($eq(case_.name, "design")) ? [] : ["load_case", case_.name]));
return $replaced(problem, new Map([["key", ("" + $str(problems__place_text([...$iter(own), "train"])) + "." + $str(rest))], ["file", file]]));
}
}
return $replaced(problem, new Map([["file", file]]));
}
function problems__place_text(place) {
let key, step, text;

(text = "");
for (step of $iter(place)) {
if ($truth($b.isinstance(step, "int"))) {
(text = $add(text, ("" + "[" + $str(step) + "]")));
continue;
}
(key = ($truth($m.fullmatch($c39, step)) ? step : $shown(step)));
(text = $add(text, ($truth(text) ? ("" + "." + $str(key)) : key)));
}
return text;
}
function source__syntax_problem(text, line, file = "") {
let lines, message, remedy, value, written;

(lines = $m.split(text, "\n"));
(written = ((0 < line && line <= $b.len(lines)) ? $m.strip($at(lines, $sub(line, 1))) : ""));
(message = "not valid TOML");
(remedy = "Text needs quotes, and so does a quantity: width = \"1200 mm\".");
if (!$truth($m.strip($m.join("", $slice(lines, $sub(line, 1), null))))) {
([message, remedy] = ["ends too early", "Close the bracket or the quotes that are left open."]);
} else {
if ($truth(source___stands_before(written, $slice(lines, null, $sub(line, 1))))) {
([message, remedy] = ["is there twice", "Leave one of them out."]);
} else {
if (($in("\\", written))) {
(remedy = "Write paths with / , or in single quotes: 'C:\\drives\\lagging.toml'.");
}
}
}
(value = ($truth(written) ? $shown(written) : ""));
return new Problem(message, remedy, file, undefined, value, line);
}
function source___stands_before(written, lines) {
let before, key, keys;

(key = $m.strip($at($m.partition(written, "="), 0)));
if ($truth($m.startswith(written, "["))) {
return ($in(written, [...(function* () { for (const before of $iter(lines)) { yield $m.strip(before); } })()]));
}
(keys = []);
for (before of $iter(lines)) {
(keys = ($truth($m.startswith(before, "[")) ? [] : [...$iter(keys), $m.strip($at($m.partition(before, "="), 0))]));
}
return $and((!$eq(key, "")), () => ($in(key, keys)));
}
function in_page_checks__arcs_of(drive) {

return [...(function* () { for (const case_ of $iter(drive.load_cases)) { for (const p of $iter(drive.pulleys)) { yield WrapArc.of(drive, p, case_); }} })()];
}
function in_page_checks__given_of(drive, arc) {
let of;

(of = arc.described());
return new in_page$Given(of.entry_tension, of.exit_tension, NaN, NaN, NaN, of.diameter, of.wrap_angle, of.overrun, of.recovery, of.width, drive.belt.modulus, in_page_checks___known($bound(drive.belt, "speed")), of.thickness, of.shear_modulus, of.compression_modulus, of.wear_coefficient, arc.creep_limit, arc.law.steepest_fall(), of.pitch_offset, arc.cover_compliance, in_page_checks___known($bound(drive.belt, "mass")), arc.slip_with_shear, of.belt_speed);
}
function in_page_checks___known(value) {
return ((value == null) ? NaN : value);
}
function in_page_checks__criteria_of(drive, arcs, index) {
let arc, case_, pulley, rise;

(arc = $at(arcs, index));
([case_, pulley] = [drive.load_case($bound(arc, "load_case")), drive.pulley($bound(arc, "pulley"))]);
(rise = gross_slip__rises(arcs, index, $bound(drive.criteria, "take_up")));
return new in_page$Criteria(drive.criteria.safety.of($bound(case_, "kind")), rise.tight, rise.slack, arc.cover_left_out, $mul(in_page_checks___known($bound(drive.belt, "breaking_strength")), arc.width), in_page_checks___known($bound(pulley, "mass")), of_data__wet_factor(pulley.lagging_in($bound(case_, "condition"))));
}
function gross_slip__rises(arcs, index, take_up) {
let after, names, pulls;

([pulls, names] = [[...(function* () { for (const arc of $iter(arcs)) { yield arc.effective_tension; } })()], [...(function* () { for (const arc of $iter(arcs)) { yield arc.pulley; } })()]]);
(after = ($truth(take_up.after) ? $m.index(names, $bound(take_up, "after")) : $neg(1)));
return new Rise(...$iter($b.map($b.float, numbers__rise_among(pulls, index, $bound(take_up, "fixed"), after))));
}
function numbers__rise_among(pulls, index, fixed, after) {
let ahead, behind, entry, leaving, lost, mine, total;

([total, mine] = [$b.sum(pulls), $at(pulls, index)]);
(ahead = $b.sum($slice(pulls, null, index)));
(behind = $b.sum($slice(pulls, $add(index, 1), null)));
(lost = ($truth(fixed) ? $mul(0.5, $b.abs(total)) : 0.0));
if ((!$truth(fixed) && (after >= 0))) {
(lost = ((total >= 0.0) ? $b.sum($slice(pulls, $add(after, 1), null)) : $neg($b.sum($slice(pulls, null, $add(after, 1))))));
}
(entry = $sub(((total >= 0.0) ? $add(mine, behind) : $neg(ahead)), lost));
(leaving = $sub(((total >= 0.0) ? behind : $sub($neg(ahead), mine)), lost));
return ((mine >= 0.0) ? [entry, leaving] : [leaving, entry]);
}
function of_data__wet_factor(lagging) {

if ((!$eq(lagging.condition, "dry"))) {
return 0.0;
}
try {
return $at(new Condition("wet").factor_of(lagging), 0);
} catch ($error) {
if ($error instanceof InputError) {
return NaN;
} else throw $error;
}
}
function in_page_checks__results_of(drive, arcs, found) {
let every;

(every = $b.tuple((function* () { for (const [arc, numbers] of $iter($b.zip(arcs, found, $k({strict: true})))) { yield in_page_checks__result_of(arc, numbers); } })()));
return new DriveResult(drive, every);
}
function in_page_checks__result_of(arc, found) {
let of;

(of = found.summary);
return new FoundArc(($truth($told($c40, found, "solved")) ? "The pulley carries its load." : "Breakaway: no creep makes enough friction for this tension ratio. Raise the slack-side tension (take-up), enlarge the wrap angle, or choose a lagging with more friction."), "distributed", arc, null, of.entry_tension, of.exit_tension, of.exit_creep, of.creep_shrinkage, of.creep_compression, of.creep_global, of.exit_slip, of.entry_creep_ratio, of.exit_creep_ratio, of.peak_shear_stress, of.peak_shear_angle, of.peak_shear_position, of.mean_friction, of.active_arc, of.outside_tested_share, of.stuck_arc, found.capacities, of, found);
}
function in_page_checks__train_drive(train, case_, pairs) {

return result__drive_with(train, [unsolved__load_case(train, case_, [...(function* () { for (const at of $iter(pairs)) { yield [at.entry, at.exit]; } })()])]);
}
function unsolved__load_case(train, case_, pairs) {
let names, tensions;

(names = [...(function* () { for (const p of $iter(train.pulleys)) { yield p.name; } })()]);
(tensions = $map([...(function* () { for (const [n, [a, b]] of $iter($b.zip(names, pairs, $k({strict: true})))) { yield [n, new Tensions(a, b)]; } })()]));
return new LoadCase(case_.name, tensions, case_.kind, case_.condition);
}
function result__drive_with(train, cases) {

return new Drive(train.title, train.belt, train.pulleys, $b.tuple(cases), train.creep_limit, train.criteria, train.description);
}
function in_page_checks__running_at(arcs, speeds) {

return [...(function* () { for (const [arc, speed] of $iter($b.zip(arcs, speeds, $k({strict: true})))) { yield $replaced(arc, new Map([["belt_speed", ($truth($math.isnan(speed)) ? null : speed)]])); } })()];
}
function in_page_checks__alone(drive, name) {
let cases;

(cases = [...(function* () { for (const case_ of $iter(drive.load_cases)) { if (!(($eq(case_.name, name)))) continue; yield case_; } })()]);
return $replaced(drive, new Map([["load_cases", $slice($or(cases, () => drive.load_cases), null, 1)]]));
}
function in_page_checks__remarks_of(drive, verdict) {
let left;

(left = (function* () { for (const of of $iter(drive.laggings)) { if (!(($truth(of.fit) && $truth(of.fit.knots)))) continue; yield $m.format("The interval of the creep that the fit of {} leaves is not found in this page; wraparc solve tells it.", [$bound(of, "name")], $map([])); } })());
return [...$iter(verdict.data), ...$iter($b.fromkeys(left))];
}
function in_page_checks__weak_kinds(drive) {
let _, found, grounds, pulley;

(found = []);
for (pulley of $iter(drive.pulleys)) {
([grounds, _] = of_data__law_words($bound(pulley, "lagging")));
(found = $add(found, [...$iter(grounds), ...$iter((function* () { for (const [kind, _] of $iter(of_data__weak_sources(drive, pulley))) { yield kind; } })())]));
}
return [...(function* () { for (const kind of $iter($c42)) { if (!(($in(kind, found)))) continue; yield kind; } })()];
}
function of_data__law_words(lagging) {
let friction, law, untested, words;

([law, friction] = [$b.str($bound(lagging.source_of("law"), "kind")), ("" + "The friction of " + $str(lagging.name) + " is")]);
(words = (($in(law, $c41)) ? [("" + $str(friction) + " " + $str($at($c41, law)) + ".")] : []));
(untested = (lagging.law.tested == null));
(words = $add(words, ($truth(untested) ? [("" + $str(friction) + " given without tests.")] : [])));
return [[law, ...$iter(($truth(untested) ? ["untested"] : []))], words];
}
function* of_data__weak_sources(drive, pulley) {
let belt, lagging, owners, source, told, what;

([lagging, belt] = [pulley.lagging, drive.belt]);
(owners = [[lagging.name, $map([...(function* () { for (const [k, v] of $iter($m.items(lagging.sources))) { if (!((!$eq(k, "law")))) continue; yield [k, v]; } })()])], ["the belt", belt.sources], [("" + "pulley " + $str(pulley.name)), pulley.sources]]);
(told = [...(function* () { for (const [owner, of] of $iter(owners)) { for (const [k, v] of $iter($m.items(of))) { yield [("" + $str($m.replace(k, "_", " ")) + " of " + $str(owner)), v]; }} })()]);
if (((pulley.across != null) && (belt.in_plane_shear_stiffness == null))) {
yield ["estimated", "in-plane shear stiffness of the belt"];
}
if (($truth(pitch__covered(belt)) && (belt.cover_shear_modulus == null))) {
yield ["estimated", "cover shear modulus of the belt"];
}
for ([what, source] of $iter([...$iter(told), ["the belt", belt.provenance]])) {
yield* $iter((function* () { for (const kind of $iter(of_data__weaknesses(source))) { yield [kind, what]; } })());
}
}
function pitch__covered(belt) {
let found;

(found = pitch__layers_of(belt));
return $or((found.pulley_cover > 0.0), () => (found.carry_cover > 0.0));
}
function* of_data__weaknesses(source) {

if ($truth($m.startswith(source.note, "estimated"))) {
yield "estimated";
}
if (($in(source.kind, ["illustrative", "calibrated"]))) {
yield $b.str($bound(source, "kind"));
}
}
function in_page_checks__unjudged(drive) {

if ($truth($b.any((function* () { for (const arc of $iter(in_page_checks__arcs_of(drive))) { yield rules__idle(arc); } })()))) {
return 2;
}
return ($truth($b.any((function* () { for (const _ of $iter(usual__unusual_sizes(drive, false))) { yield true; } })())) ? 3 : 0);
}
function rules__idle(arc) {

return numbers__idles($bound(arc, "entry_tension"), $bound(arc, "exit_tension"));
}
function* usual__unusual_sizes(drive, odd) {
let case_, dimension, least, made, most, name, names, place, pulley, size, value, values;

for (case_ of $iter(drive.load_cases)) {
for (pulley of $iter(drive.in_case(case_).pulleys)) {
(names = usual___names(pulley, case_));
(values = numbers__compared_sizes(usual___sizes(drive, case_, pulley)));
for ([[name, dimension, place], value, [least, most]] of $iter($b.zip(names, values, $c43, $k({strict: true})))) {
(made = $or(($in(name, ["modulus over the rating of the belt", "strength over the rating of the belt", "tension that keeps the belt from sagging"])), () => $m.startswith(name, "pressure of the belt at its rating")));
if (!($truth(numbers__usual(value, least, most)) || ($truth(made) && $truth(odd)))) {
(size = (($in(dimension, $c44)) ? drive.belt.width : 1.0));
(odd = true);
yield usual__unusual(name, dimension, place, $mul(size, value), [$mul(size, least), $mul(size, most)]);
}
}
}
}
}
function usual___names(pulley, case_) {
let at, belt, drum, lagging, of;

([belt, drum, at] = [new Place(), new Place($bound(pulley, "name")), new Place($bound(pulley, "name"), $bound(case_, "name"))]);
([lagging, of] = [("" + "of lagging " + $str(pulley.lagging.name)), ("" + "of pulley " + $str(pulley.name))]);
return [["width of the belt", "length", belt], ["modulus of the belt", "force_per_width", belt], ["speed of the belt", "speed", belt], [("" + "diameter " + $str(of)), "length", drum], [("" + "wrap angle " + $str(of)), "angle", drum], [("" + "wrap angle " + $str(of)), "angle", drum], [("" + "creep limit " + $str(of)), "length", drum], [("" + "overrun " + $str(of)), "length", drum], [("" + "thickness " + $str(lagging)), "length", drum], [("" + "shear modulus " + $str(lagging)), "pressure", drum], [("" + "compression modulus " + $str(lagging)), "pressure", drum], ["rating of the belt", "force_per_width", belt], [("" + "bond strength " + $str(lagging)), "pressure", drum], [("" + "fatigue limit " + $str(lagging)), "pressure", drum], ["largest wrap pressure of the belt", "pressure", belt], ["least pulley of the belt", "length", belt], ["tension that keeps the belt from sagging", "force", belt], ["modulus over the rating of the belt", "number", belt], ["strength over the rating of the belt", "number", belt], [("" + $str("pressure of the belt at its rating") + " on pulley " + $str(pulley.name)), "pressure", drum], [("" + "entry tension " + $str(of)), "force", at], [("" + "exit tension " + $str(of)), "force", at], [("" + "power " + $str(of)), "power", at], ["mass of the belt", "mass_per_length", belt]];
}
function usual___sizes(drive, case_, pulley) {
let belt, idle, lagging, sag, tensions;
([belt, lagging, sag] = [drive.belt, pulley.lagging, drive.criteria.sag]);
(tensions = $at(case_.tensions, pulley.name));
(idle = numbers__idles($bound(tensions, "entry"), $bound(tensions, "exit")));
function known(value) {
return ((value == null) ? NaN : value);
}
$sig(known, ["value"], false);
return new Sizes(belt.width, belt.modulus, known($bound(belt, "speed")), pulley.diameter, ($truth(idle) ? pulley.wrap_angle : NaN), ($truth(idle) ? NaN : pulley.wrap_angle), drive.creep_limit_of(pulley), known($bound(pulley, "overrun")), lagging.thickness, lagging.shear_modulus, lagging.compression_modulus, known($bound(belt, "rating")), known($bound(belt, "breaking_strength")), known($bound(lagging, "bond_strength")), known($bound(lagging, "fatigue_limit")), known($bound(belt, "largest_wrap_pressure")), known($bound(belt, "least_pulley_diameter")), known(((sag == null) ? null : sag.tension)), tensions.entry, tensions.exit, (($truth(idle) || ($b.len($bound(drive, "pulleys")) > 1)) ? NaN : tensions.effective), known($bound(belt, "mass")));
}
function numbers__compared_sizes(of) {

return [of.width, of.modulus, of.speed, of.diameter, of.idle_wrap, of.wrap_angle, of.creep_limit, of.overrun, of.thickness, of.shear_modulus, of.compression_modulus, of.rating, of.bond_strength, of.fatigue_limit, of.face_pressure, of.least_diameter, (of.sag / of.width), (of.modulus / of.rating), (of.strength / of.rating), ($mul(2.0, of.rating) / of.diameter), (of.entry / of.width), (of.leaving / of.width), $mul($b.abs($bound(of, "pull")), of.speed), (of.mass / of.width)];
}
function numbers__usual(value, least, most) {

return !((value < least) || ((value > most) && $truth($math.isfinite(value))));
}
function usual__unusual(name, dimension, place, value, ends) {
let least, meant, most, near, remedy;

([least, most] = ends);
(meant = $m.join(" or ", parse__meant_by(value, dimension, least, most)));
(remedy = ($truth(meant) ? ("" + "Check the unit: " + $str(meant) + "?") : "Check the unit."));
if (($eq(dimension, "number"))) {
(near = $b.next((function* () { for (const n of $iter([0.1, 10.0, 0.01, 100.0])) { if (!((least <= $mul(n, value) && $mul(n, value) <= most))) continue; yield n; } })(), null));
(remedy = ((near == null) ? "Check the number." : ("" + "Is " + $format($mul(near, value), ("" + ".3g")) + " meant?")));
}
if ((($eq(dimension, "angle")) && (value > most))) {
(remedy = "Is it the sum of two pulleys? Give each of them its own.");
} else {
if ((($eq(dimension, "angle")) && !$truth(meant))) {
(remedy = "Is it what a snub pulley adds to half a turn? Give the sum.");
}
}
if ($truth($m.startswith(name, "pressure of the belt at its rating"))) {
(remedy = "Check the diameter and the rating.");
}
if (($eq(name, "strength over the rating of the belt"))) {
(remedy = "Check strength and rating.");
}
if ((($eq(name, "mass of the belt")) && (value > most))) {
(remedy = "Is it that of the whole belt? Give the mass of a metre.");
}
if (($eq(name, "modulus over the rating of the belt"))) {
(remedy = "Is the rating or the strength given as the modulus? Check the units of both.");
}
return new Check("usual_sizes", ("" + "Usual " + $str(name)), $at($c46, "usual_sizes").missed, place, value, ((value > most) ? most : least), dimension, (value > most), "sizes that conveyor drives have", "unusual size", ("" + "The " + $str(check__escaped(name)) + ", {value}, is outside the usual {least} to {most}."), check__escaped(remedy), undefined, $map([["least", [least, dimension]], ["most", [most, dimension]]]), false);
}
function parse__meant_by(value, dimension, least, most) {
let found, inside, number, short, text, unit, units, written;

(found = []);
(units = $m.get($c45, dimension, []));
for (written of $iter(units)) {
(number = (value / parse__unit_factor(written, dimension)));
(short = $b.float(("" + $format(number, ("" + ".3g")))));
if (($b.abs($sub(number, short)) > $mul(1e-09, $b.abs(short)))) {
continue;
}
for (unit of $iter(units)) {
(text = ("" + $format(short, ("" + "g")) + " " + $str(unit)));
(inside = (least <= $mul(short, parse__unit_factor(unit, dimension)) && $mul(short, parse__unit_factor(unit, dimension)) <= most));
if (($truth(inside) && (!$eq(unit, written)) && (!$in(text, (function* () { for (const [_, t] of $iter(found)) { yield t; } })())))) {
$m.append(found, [!(1.0 <= short && short < 1000.0), text]);
}
}
}
return [...(function* () { for (const [_, text] of $iter($slice($b.sorted(found, $k({key: ((one) => $at(one, 0))})), null, 2))) { yield text; } })()];
}
function check__escaped(text) {

return $m.replace($m.replace(text, "{", "{{"), "}", "}}");
}
function judge__judge(result) {
let most, one, over, verdict;

if ((!$in(result, $c47))) {
(verdict = new Verdict(judge__sound(judge__every_check(result), least_tension__least_tension(result))));
if ((verdict.level === "OK")) {
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
([most, over] = judge___wet(one));
(verdict = $replaced(verdict, new Map([["wet", most], ["over_wet", over]])));
}
$put($c47, result, verdict);
}
return $at($c47, result);
}
function judge__every_check(result) {

return $b.tuple(($truth($b.isinstance(result, TrainResult)) ? judge___train(result) : judge___drive(result)));
}
function* judge___train(result) {
let adrift, case_, check, title;
for (case_ of $iter(result)) {
yield* $iter(judge___of_train($bound(result, "train"), case_));
if ($truth($b.isinstance(case_.case.division, Pulls))) {
yield* $iter(judge___meeting(case_));
}
}
(adrift = new Set((function* () { for (const case_ of $iter(result)) { if (!($truth(case_.adrift))) continue; yield case_.case.name; } })()));
for (check of $iter(judge___drive(result.drive_result(), ...$iter(usual__of_train($bound(result, "train")))))) {
if ((($eq(check.name, "gross_slip")) && ($in(check.place.load_case, adrift)))) {
(title = $m.format("Safety against gross slip, {}", [$bound(result.train.case($bound(check.place, "load_case")), "kind")], $map([])));
yield of_drive__not_checked($bound(check, "name"), title, "no division of the load is found", $bound(check, "place"));
} else {
yield check;
}
}
}
function* judge___of_train(train, case_) {
let division, driven, member, motor, place, several;

(place = new Place("", $bound(case_.case, "name")));
if (($truth(case_.adrift) || ($in(case_.status, ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."])))) {
yield judge__operating_point($bound(case_, "status"), $bound(case_, "reason"), place);
}
(several = ($b.len($bound(case_, "members")) > 1));
if (!$truth($told($c40, case_.status, "solved"))) {
yield* $iter(($truth(several) ? judge__not_working(place) : []));
return null;
}
if ($truth(several)) {
yield judge__fight(numbers__pull_against([...(function* () { for (const m of $iter(case_.members)) { yield m.arc.effective_tension; } })()]), place);
(driven = [...(function* () { for (const [p, m] of $iter($b.zip($bound(train, "pulleys"), $bound(case_, "members"), $k({strict: true})))) { if (!(!$truth(rules__idle($bound(m.arc, "arc"))))) continue; yield p; } })()]);
yield* $iter(of_drive__unknown_trims($bound(train, "belt"), driven, place));
}
yield judge__train_balance($b.max($bound(case_, "tension_error"), $bound(case_, "speed_error")), place);
(division = case_.case.division);
for ([member, motor] of $iter($b.zip($bound(case_, "members"), ($truth($b.isinstance(division, Motors)) ? division.motors : []), $k({strict: false})))) {
yield judge___motor(member, motor, $bound(case_, "case"));
}
}
function judge__operating_point(status, reason, place) {
let fault, shorts;

(fault = (status === "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."));
(shorts = $map([["Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", "gross slip"], ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", "beyond a motor"]]));
return new Check("operating_point", "Operating point of the drives", ($truth(fault) ? "FAULT OF THE PROGRAM" : "FAILS"), place, undefined, undefined, undefined, undefined, undefined, $m.get(shorts, status, "not solved"), check__escaped($m.strip(("" + $str(reason) + " " + $str(status)))));
}
function* judge__not_working(place) {
let name, title;

for ([name, title] of $iter([["fight", "Drives work together"], ["train_balance", "Tensions, speeds and torques of the train agree"]])) {
yield of_drive__not_checked(name, title, "the drives do not carry the load", place);
}
}
function of_drive__not_checked(name, title, why, place) {

return new Check(name, title, "NOT CHECKED", place, undefined, undefined, undefined, undefined, undefined, why, check__escaped(("" + $str(title) + ": not checked, " + $str(why) + ".")));
}
function numbers__pull_against(pulls) {
let small;

(small = $mul(0.001, $b.max((function* () { for (const pull of $iter(pulls)) { yield $b.abs(pull); } })())));
if (!(($b.min(pulls) < $neg(small)) && ($b.max(pulls) > small))) {
return 0.0;
}
return $b.min($b.sum((function* () { for (const p of $iter(pulls)) { yield $b.max(p, 0.0); } })()), $b.sum((function* () { for (const p of $iter(pulls)) { yield $b.max($neg(p), 0.0); } })()));
}
function judge__fight(lost, place) {
let fights;

(fights = (lost > 0.0));
return new Check("fight", "Drives work together", ($truth(fights) ? "ATTENTION" : "OK"), place, undefined, undefined, undefined, undefined, undefined, ($truth(fights) ? "drives fight" : ""), ($truth(fights) ? "The drives work against each other with {lost} of pull." : ""), ($truth(fights) ? "Bring their speeds closer together, or divide the load by torque." : ""), undefined, $map([["lost", [lost, "force"]]]));
}
function* of_drive__unknown_trims(belt, pulleys, at) {
let first, opposite, place, pulley, shift;

for (pulley of $iter($slice(pulleys, 1, null))) {
(first = $at(pulleys, 0));
(shift = of_drive__open_shift(belt, first, pulley));
if ((shift > 0.0)) {
([place, opposite] = [$replaced(at, new Map([["pulley", pulley.name]])), (!$eq(pulley.side, first.side))]);
yield of_drive__unknown_trim($bound(first, "name"), shift, opposite, place);
}
}
}
function of_drive__open_shift(belt, first, other) {
let shift;

if ($truth($b.all((function* () { for (const pulley of $iter([first, other])) { yield (pitch__pitch_offset(belt, $bound(pulley, "side")) != null); } })()))) {
return 0.0;
}
(shift = numbers__trim_shift($bound(first, "diameter"), $bound(other, "diameter"), (!$eq(first.side, other.side))));
return ((shift > 0.0001) ? shift : 0.0);
}
function numbers__trim_shift(first, other, opposite) {

if ($truth(opposite)) {
return (0.004 / $mul(0.5, $b.min(first, other)));
}
return $b.abs($sub((0.005 / $mul(0.5, first)), (0.005 / $mul(0.5, other))));
}
function of_drive__unknown_trim(first, shift, opposite, place) {
let why;

(why = ("" + "10 mm of belt on drums of two diameters shifts it by {shift} % against " + $str(first) + "."));
if ($truth(opposite)) {
(why = ("" + "it meets the other side of the belt than " + $str(first) + ", and covers that differ by 4 mm shift it by {shift} %."));
}
return new Check("belt_thickness", "Trim by the thickness of the belt", "ATTENTION", place, undefined, undefined, undefined, undefined, undefined, "trim without belt thickness", ("" + "The trim of " + $str(check__escaped($bound(place, "pulley"))) + " is that of a belt without thickness: " + $str(why)), "Give pulley_cover, carry_cover and carcass in [belt].", undefined, $map([["shift", [$mul(100.0, shift), "number"]]]), false);
}
function judge__train_balance(error, place) {

return of_drive__judged($at($c46, "train_balance"), "Tensions, speeds and torques of the train agree", error, 1e-05, "number", place, "tolerance of the program", "Tensions, speeds and torques of the train miss each other by {value}.", "Please report the drive file; until then change a value slightly.", undefined, "out of balance", undefined, undefined, false);
}
function of_drive__judged(rule, title, value, limit, dimension, place, source = "", says = "", remedy = "", otherwise = "", short = "", because = "", allows = "", binding = true, more = null) {
let kept, level, miss;

(kept = $and(!$truth($math.isnan(value)), () => check__keeps(value, limit, rule.at_most)));
(miss = new Miss($bound(rule, "missed"), short, says, remedy, $bound(rule, "fails_beyond"), because, $bound(rule, "tolerates"), allows, otherwise));
([level, says] = miss.at(value, $bound(rule, "at_most")));
return new Check(rule.name, title, ($truth(kept) ? "OK" : level), place, value, limit, dimension, rule.at_most, source, ($truth(kept) ? "" : short), ($truth(kept) ? "" : says), ($truth(kept) ? "" : remedy), ($truth(kept) ? "" : otherwise), $or(more, () => $map([])), binding, miss);
}
function check__keeps(value, limit, at_most = true) {

return numbers__kept(value, limit, at_most);
}
function numbers__kept(value, limit, at_most) {
let within;

if ($truth($math.isnan(value))) {
return false;
}
(within = ($truth(at_most) ? (value <= limit) : (value >= limit)));
return $or(within, () => numbers__same_shown(value, limit));
}
function numbers__same_shown(value, limit) {

if (!($truth($math.isfinite(value)) && $truth($math.isfinite(limit)))) {
return ($eq(value, limit));
}
return ($eq(("" + $format(value, ("" + ".3e"))), ("" + $format(limit, ("" + ".3e")))));
}
function judge___motor(member, motor, case_) {
let at, momentary;

([at, momentary] = [new Place($bound(member, "name"), $bound(case_, "name")), (!$eq(case_.kind, "running"))]);
if (((member.motor == null) || !$truth($b.isinstance(motor, Motor)))) {
return judge__unrated(momentary, at);
}
return judge__motor_load($bound(member.motor, "motor_load"), motor.bears(momentary), momentary, at);
}
function judge__unrated(momentary, place) {
let name, why;

(name = ($truth(momentary) ? "momentary_load" : "motor_load"));
(why = "a drive that follows another gives no rating of its motors");
return of_drive__not_checked(name, $at($c48, momentary), why, place);
}
function judge__motor_load(load, most, momentary, place) {
let remedy, title;

(title = $at($c48, momentary));
(remedy = "Divide the load otherwise (diameters, speeds, torque sharing), or take larger motors.");
if ($truth(momentary)) {
(remedy = "Start and stop more slowly, divide the load otherwise, or take larger motors.");
}
return of_drive__judged($at($c46, ($truth(momentary) ? "momentary_load" : "motor_load")), title, $b.abs(load), most, "number", place, ($truth(momentary) ? "IEC 60034-1: 1.6 times the rated torque for 15 s; no stall at 90 % of the voltage (NEMA MG 1-12.44, condensed edition of 2011: torque falls with its square)" : "rating of the motor, continuous duty"), "The motors work at {percent} % of their rated torque, and may at {most} %.", remedy, undefined, "motor overloaded", "The usual service factor, 1.15, does not cover that (NEMA MG 1-14.37: up to that of the nameplate).", undefined, undefined, $map([["percent", [$mul(100.0, $b.abs(load)), "number"]], ["most", [$mul(100.0, most), "number"]]]));
}
function* judge___meeting(case_) {
let ends, one, other, place;

for ([one, other] of $iter($b.pairwise((function* () { for (const m of $iter(case_.members)) { yield m.arc.arc; } })()))) {
(ends = [one.exit_tension, other.pulley, other.entry_tension]);
(place = new Place($bound(other, "pulley"), $bound(case_.case, "name")));
yield* $iter(of_drive__meeting($bound(one, "pulley"), ...$iter(ends), place));
}
}
function* of_drive__meeting(before, leaves, after, enters, place) {

if (($b.abs($sub(leaves, enters)) <= $mul(0.02, $b.max(leaves, enters)))) {
return null;
}
yield new Check("meeting", "Tensions of neighbouring pulleys meet", "ATTENTION", place, undefined, undefined, undefined, undefined, undefined, "tensions do not meet", ("" + "The belt leaves pulley " + $str(check__escaped(before)) + " with {leaves} and enters pulley " + $str(check__escaped(after)) + " with {enters}: taken as what the run between them adds."), ("" + "If none does, correct the tensions or the order of the pulleys; if one does, say so in [train]: run." + $str(check__escaped(after)) + "."), undefined, $map([["leaves", [leaves, "force"]], ["enters", [enters, "force"]]]), false);
}
function* usual__of_train(train) {
let division, motor, pulley, turns;

(division = $at(train.cases, 0).division);
if (($truth($b.isinstance(division, Speeds)) && $truth(division.absolute))) {
for ([pulley, turns] of $iter($b.zip($bound(train, "pulleys"), $bound(division, "rotation_speeds"), $k({strict: true})))) {
yield new Owner(turns, "", new Place($bound(pulley, "name")));
}
}
for ([pulley, motor] of $iter($b.zip($bound(train, "pulleys"), ($truth($b.isinstance(division, Motors)) ? division.motors : []), $k({strict: false})))) {
yield new Owner(motor, ("" + "of the motor of pulley " + $str(pulley.name)), new Place($bound(pulley, "name")));
}
}
function* judge___drive(result, ...others) {
let arc, arcs, by_case, cases, drive, name, pulley;
(drive = result.drive);
(cases = $map([...(function* () { for (const case_ of $iter(drive.load_cases)) { yield [case_.name, case_]; } })()]));
(by_case = $map([]));
for (arc of $iter(result)) {
$m.append($m.setdefault(by_case, $bound(arc.arc, "load_case"), []), arc);
}
for ([name, arcs] of $iter($m.items(by_case))) {
yield* $iter(judge___case(drive.in_case($at(cases, name)), $at(cases, name), arcs));
}
if ($truth($b.any((function* () { for (const pulley of $iter(drive.pulleys)) { yield pulley.across; } })()))) {
yield* $iter(in_page_checks__across(result));
}
yield* $iter(of_drive__take_up(drive));
for (pulley of $iter(drive.pulleys)) {
yield of_drive__pulley_diameter(drive, pulley);
}
yield* $iter(in_page_checks__usual_sizes(drive, ...$iter(others)));
for (pulley of $iter(drive.pulleys)) {
yield of_data__data(drive, pulley);
}
}
function* judge___case(drive, case_, arcs) {
let balanced, found, index, pulley, result, sag;
for ([index, result] of $iter($b.enumerate(arcs))) {
(pulley = drive.pulley($bound(result.arc, "pulley")));
(found = [of_arc__grip(drive, case_, arcs, index), of_arc__standard(drive, case_, result), of_arc__creep(drive, result), of_arc__cover_creep(result), in_page_checks__creep_interval(drive, result)]);
yield* $iter((function* () { for (const check of $iter(found)) { if (!((check != null))) continue; yield check; } })());
yield of_drive__belt_tension(drive, case_, pulley);
yield of_drive__belt_safety(drive, case_, pulley);
yield of_drive__face_pressure(drive, case_, pulley);
yield* $iter(of_arc__lagging_stress(pulley, result));
yield* $iter(of_drive__tested_pressure(drive, case_, pulley));
yield* $iter(of_data__condition(case_, pulley));
yield* $iter(of_data__fit(case_, pulley));
yield* $iter(of_arc__tested_slip(pulley, result));
if (($truth($b.all((function* () { for (const arc of $iter(arcs)) { yield rules__idle($bound(arc, "arc")); } })())) || ((result.arc.side < 0.0) && !$truth(rules__idle($bound(result, "arc")))))) {
yield of_drive__sense(case_, pulley);
}
(balanced = of_arc__balance(result));
if ((balanced != null)) {
yield balanced;
}
}
(sag = of_drive__sag(drive, case_));
if ((sag != null)) {
yield sag;
}
}
function of_arc__grip(drive, case_, arcs, index) {
let name, place, result, rise, take_up, title;

(result = $at(arcs, index));
([take_up, name] = [drive.criteria.take_up, $at($c46, "gross_slip").name]);
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
(title = $m.format("Safety against gross slip, {}", [$bound(case_, "kind")], $map([])));
if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return new Check(name, title, "FAULT OF THE PROGRAM", place, undefined, undefined, undefined, undefined, undefined, "not solved", check__escaped($b.str($bound(result, "status"))));
}
if ($truth(rules__idle($bound(result, "arc")))) {
return new Check(name, "No pull to carry", "OK", place, undefined, undefined, undefined, undefined, undefined, "not driven");
}
(rise = gross_slip__rises([...(function* () { for (const r of $iter(arcs)) { yield r.arc; } })()], index, take_up));
return of_arc__of_sliding(drive, case_, result, in_page_checks__sliding(result, rise));
}
function in_page_checks__sliding(result, _rise) {

return new Sliding($bound(result.found, "place"), $bound(result.found, "cause"));
}
function of_arc__of_sliding(drive, case_, result, found) {
let by, check, factor, first, gone, lagging, place, rule, safety, says, take_up, title;

([safety, take_up, lagging] = [drive.criteria.safety, drive.criteria.take_up, result.arc.pulley]);
([rule, factor, gone] = [$at($c46, "gross_slip"), safety.of($bound(case_, "kind")), !$truth($told($c40, result.status, "solved"))]);
([by, first] = $at($c49, found.cause));
(title = ("" + $str($m.format("Safety against gross slip, {}", [$bound(case_, "kind")], $map([]))) + ", " + $str(by)));
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
if (($truth($math.isnan($bound(found, "place"))) && !$truth(gone))) {
return of_drive__not_checked($bound(rule, "name"), title, "where the belt slides was not found", place);
}
if (($eq(found.cause, 1))) {
(rule = $replaced(rule, new Map([["fails_beyond", NaN]])));
}
(first = $m.replace(first, "⟦lagging⟧", check__escaped($bound(drive.pulley(lagging).lagging, "name"))));
(says = ("" + $str(first) + " at {value} times the pull, " + $str(of_arc__held_words(take_up)) + "; the safety factor "));
(says = $add(says, ("" + $str(case_.kind) + " is {limit}.")));
(check = of_drive__judged(rule, title, ($truth(gone) ? $b.min($bound(found, "place"), 0.999) : found.place), factor, "number", place, ("" + "safety factor " + $str(case_.kind) + ": " + $str($or(safety.source, () => "taken where the drive file says nothing"))), says, "Raise the slack-side tension, enlarge the wrap angle, or choose a lagging with more friction.", "No slack-side tension is enough: enlarge the wrap angle, or choose a lagging with more friction.", (($eq(found.cause, 1)) ? "pull beyond tests" : "near gross slip"), "So it slides.", undefined, undefined, $map([["slides", [0.0635, "length"]]])));
if (!$truth(gone)) {
return check;
}
(says = ("" + "Gross slip: no creep carries the pull. " + $str(says)));
return $replaced(check, new Map([["level", "FAILS"], ["says", says], ["short", "gross slip"], ["miss", null]]));
}
function of_arc__held_words(take_up) {
let where;

if ($truth(take_up.fixed)) {
return "T1 + T2 held (fixed take-up)";
}
(where = ($truth(take_up.after) ? ("" + "tension behind pulley " + $str(take_up.after)) : "T2"));
return ("" + $str(check__escaped(where)) + " held (gravity take-up)");
}
function of_arc__standard(drive, case_, result) {
let chosen, criteria, found, lagging, limit, place, slack, start, title;

([criteria, lagging] = [drive.criteria, drive.pulley($bound(result.arc, "pulley")).lagging]);
(found = design_standard__asked($bound(criteria, "standard"), $bound(criteria, "take_up"), lagging, $bound(result.arc, "wrap_angle")));
if (((found == null) || $truth(rules__idle($bound(result, "arc"))))) {
return null;
}
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
if ($truth($math.isnan($bound(found, "wrap_factor")))) {
(title = ("" + "Slack side by " + $str(found.rule)));
if (!$truth(criteria.standard.name)) {
return of_drive__not_checked("design_standard", title, $bound(found, "why_not"), place);
}
return new Check("design_standard", title, ($truth(criteria.standard.binding) ? "FAILS" : "ATTENTION"), place, undefined, undefined, undefined, undefined, undefined, "standard not applicable", check__escaped(("" + $str(found.rule) + " was chosen and cannot be applied: " + $str(found.why_not) + ".")), "Give what it asks for, or name another rule in [design_standard].", undefined, undefined, criteria.standard.binding);
}
(slack = $b.min($bound(result.arc, "entry_tension"), $bound(result.arc, "exit_tension")));
(limit = of_arc__design_slack(drive, case_, result, $bound(found, "wrap_factor")));
(chosen = ($truth(criteria.standard.name) ? "" : " No standard was chosen: CEMA was taken."));
(start = "");
if (((!$eq(criteria.standard.start_factor, 1.0)) && ($eq(case_.kind, "running")))) {
(start = ("" + " at " + $format(criteria.standard.start_factor, ("" + "g")) + " times the pull"));
}
return of_drive__judged(rules__standard_rule(criteria), ("" + "Slack side by " + $str(found.rule)), slack, limit, "force", place, found.source, ("" + "The slack side, {value}, is below the {limit} that " + $str(found.rule) + " asks for" + $str(start) + "." + $str(chosen)), "Raise the slack-side tension, or name the rule that you design by in [design_standard].", "Name the rule that you design by in [design_standard].", "below standard", undefined, undefined, criteria.standard.binding);
}
function design_standard__asked(standard, take_up, lagging, wrap_angle) {
let factor, found, friction;

if (($eq(standard.name, "none"))) {
return null;
}
if ($truth(design_standard__by_table(standard, take_up, lagging))) {
return design_standard___manual(lagging, wrap_angle);
}
([friction, found] = design_standard___friction(standard, lagging));
if ((friction == null)) {
return found;
}
(factor = constant_friction__wrap_factor(friction, wrap_angle));
return $replaced(found, new Map([["wrap_factor", ($truth(design_standard__prints(standard, $bound(lagging, "surface"))) ? numbers__as_printed(factor) : factor)]]));
}
function design_standard__by_table(standard, take_up, lagging) {

return $and(design_standard___cema(standard), () => $and(take_up.fixed, () => $b.bool($bound(lagging, "surface"))));
}
function design_standard___cema(standard) {
return $and((standard.friction == null), () => ($eq($or(standard.name, () => "CEMA"), "CEMA")));
}
function design_standard___manual(lagging, wrap_angle) {
let angle, ends, factor, rows;
(rows = design_standard___rows(lagging));
(angle = $math.degrees(wrap_angle));
if (!($sub($at($at(rows, 0), 0), 1e-09) <= angle && angle <= $add($at($at(rows, $neg(1)), 0), 1e-09))) {
(ends = ("" + $format($at($at(rows, 0), 0), ("" + "g")) + " to " + $format($at($at(rows, $neg(1)), 0), ("" + "g")) + " degrees"));
return design_standard___silent("CEMA", ("" + "its factors for manual take-ups are for wraps of " + $str(ends)));
}
(factor = $b.next((function* () { for (const [row, value] of $iter($b.reversed(rows))) { if (!((row <= $add(angle, 1e-09)))) continue; yield value; } })()));
return new Asked(("" + "CEMA, manual take-up, Cw " + $format(factor, ("" + "g"))), factor, "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8)");
}
function design_standard___rows(lagging) {
return $at($c50, (($eq(lagging.surface, "bare")) ? "bare" : "lagged"));
}
function design_standard___silent(name, why) {
return new Asked(name, NaN, "", why);
}
function design_standard___friction(standard, lagging) {
let condition, found, friction, name, rule, stated, value;

(name = $or(standard.name, () => "CEMA"));
if ((standard.friction != null)) {
(rule = ("" + "your own rule, friction " + $format(standard.friction, ("" + ".2f"))));
return [standard.friction, new Asked(rule, NaN, "given")];
}
if (!$truth(lagging.surface)) {
return [null, design_standard___silent(name, ("" + "lagging " + $str(lagging.name) + " does not say what its surface is"))];
}
(condition = $or(standard.condition, () => lagging.condition));
(found = [...(function* () { for (const d of $iter((() => $c51)())) { if (!((($eq(d.standard, name)) && ($eq(d.surface, lagging.surface))))) continue; yield d; } })()]);
(value = $b.next((function* () { for (const d of $iter(found)) { if (!(($in(d.condition, ["", condition])))) continue; yield d; } })(), null));
if ((value == null)) {
return [null, design_standard___silent(name, ("" + "it has no value for " + $str(lagging.surface) + " when " + $str(condition)))];
}
(friction = $at(value.friction, 0));
(stated = $m.join(", ", (function* () { for (const part of $iter([value.surface, value.condition])) { if (!($truth(part))) continue; yield part; } })()));
(rule = ("" + $str(name) + ", friction " + $format(friction, ("" + ".2f")) + " (" + $str(stated) + ")"));
return [friction, new Asked(rule, NaN, $b.str($bound(value, "provenance")))];
}
function constant_friction__wrap_factor(friction, wrap_angle) {

return (1.0 / $math.expm1($mul(friction, wrap_angle)));
}
function design_standard__prints(standard, surface) {

return $and(design_standard___cema(standard), () => ($in(surface, ["bare", "rubber"])));
}
function numbers__as_printed(factor) {

return $b.min(factor, ($math.floor($add($mul(100.0, factor), 0.5)) / 100.0));
}
function of_arc__design_slack(drive, case_, result, factor) {
let start;

(start = rules__start_factor($bound(drive, "criteria"), $bound(case_, "kind")));
return numbers__asked_slack(factor, start, $bound(result.arc, "effective_tension"));
}
function rules__start_factor(criteria, kind) {

return (($eq(kind, "running")) ? criteria.standard.start_factor : 1.0);
}
function numbers__asked_slack(factor, start, pull) {

return $mul($mul(factor, start), $b.abs(pull));
}
function rules__standard_rule(criteria) {
let rule;

(rule = $at($c46, "design_standard"));
return ($truth(criteria.standard.binding) ? $replaced(rule, new Map([["missed", "FAILS"]])) : rule);
}
function of_arc__creep(drive, result) {
let limit, place, title;

([title, place] = ["Creep at exit", new Place($bound(result.arc, "pulley"), $bound(result.arc, "load_case"))]);
if (!$truth($told($c40, result.status, "solved"))) {
return of_drive__not_checked("creep", title, of_arc__no_state(result), place);
}
(limit = result.arc.creep_limit);
return of_drive__judged($at($c46, "creep"), title, $b.abs($bound(result, "exit_creep")), limit, "length", place, (($eq(limit, 0.00635)) ? "conservative limit, 1/4 in; B. DeVries, A model of lagging friction" : "given"), "Creeps {value}, more than the limit of {limit}.", "Raise the slack-side tension, enlarge the wrap angle, or choose a lagging with more friction.", "No slack-side tension is enough: enlarge the wrap angle, or choose a lagging with more friction.", "over creep limit", "A belt that creeps more than {slides} slides.", of_arc___qualifies(drive, limit), undefined, $map([["fabric", [$at($c52, "fabric"), "force_per_width"]], ["slides", [0.0635, "length"]], ["allowed", [$at($c46, "creep").tolerates, "length"]]]));
}
function of_arc__no_state(result) {

if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return "the arc was not solved";
}
return "in gross slip the belt has no state at rest";
}
function of_arc___qualifies(drive, limit) {
let belt, least, over, rating, steel, strong;

(belt = drive.belt);
if ((!$eq(limit, 0.00635))) {
return "";
}
(least = $m.get($c52, $bound(belt, "kind")));
([steel, rating] = [($eq(belt.kind, "steel cord")), belt.rating]);
if (((least == null) || ((rating == null) && !$truth(steel)))) {
return "Whether this belt may creep more is not known: its carcass or rating is not given.";
}
(strong = $or(belt.breaking_strength, () => 0.0));
(over = ($truth(steel) ? (strong > least) : ($or(rating, () => 0.0) > $mul(least, $add(1.0, 1e-09)))));
if ($truth(over)) {
return "Practice may allow this belt up to {allowed}, as it does steel cord above ST1600 and fabric above {fabric} (B. DeVries).";
}
if (($truth(steel) && !$truth(strong))) {
return "Steel cord above ST1600 may creep more; the name does not tell its strength.";
}
return "This belt does not qualify for more, as steel cord above ST1600 and fabric above {fabric} do (B. DeVries).";
}
function of_arc__cover_creep(result) {
let found, place, title, told;

([place, found] = [new Place($bound(result.arc, "pulley"), $bound(result.arc, "load_case")), result.covered_creep]);
(title = "Creep at exit, with the cover of the belt in series");
if (($eq(result.arc.cover_left_out, 0.0))) {
return null;
}
if (!$truth($told($c40, result.status, "solved"))) {
return of_drive__not_checked("cover_creep", title, of_arc__no_state(result), place);
}
(told = ($truth($math.isfinite(found)) ? "the creep is {value}" : "the belt slips through"));
return of_drive__judged($at($c46, "cover_creep"), title, $b.abs(found), $bound(result.arc, "creep_limit"), "length", place, "shear of the cover of the belt", ("" + $str("Whether the tested slip includes the shear of the belt cover is not known") + ": with the cover in series " + $str(told) + ", beyond the limit of {limit}."), "State the cover of the test belt with the shear tests, or raise the slack-side tension.", "State the cover of the test belt with the shear tests.", "limit within belt cover", undefined, undefined, false);
}
function in_page_checks__creep_interval(_drive, result) {
let fit, place;

([place, fit] = [new Place($bound(result.arc, "pulley"), $bound(result.arc, "load_case")), result.arc.fit]);
if (((fit == null) || !$truth(fit.knots))) {
return null;
}
return new Check("creep_interval", "Creep at exit, end of the 95 % interval of the law", "ATTENTION", place, undefined, undefined, undefined, undefined, undefined, "interval not found here", "By the uncertainty of the friction law the creep may be beyond its limit: this page does not find the interval.", "Solve the file with wraparc solve, which does.", undefined, undefined, false);
}
function of_drive__belt_tension(drive, case_, pulley) {
let belt, factor, limit, momentary, otherwise, place, remedy, rule, said, share, tensions, title, value;

([belt, tensions] = [drive.belt, $at(case_.tensions, pulley.name)]);
(momentary = (!$eq(case_.kind, "running")));
(title = ($truth(momentary) ? "Belt tension, momentary" : "Belt tension, running"));
(rule = rules__tension_rule($bound(case_, "kind")));
(value = $b.max($bound(tensions, "entry"), $bound(tensions, "exit")));
(place = new Place($bound(pulley, "name"), $bound(case_, "name")));
if ((belt.rating == null)) {
return of_drive__not_checked($bound(rule, "name"), title, "the rating of the belt is not given", place);
}
(factor = rules__tension_factor(belt, $bound(case_, "kind")));
(limit = $mul($mul(factor, belt.rating), belt.width));
(said = ((!$eq(factor, 1.0)) ? ("" + "its rating times " + $format(factor, ("" + "g"))) : "its rating"));
(remedy = "Lower the slack-side tension as far as the other checks allow, or take a wider or ");
([remedy, otherwise] = [("" + $str(remedy) + "stronger belt."), "Take a wider or stronger belt."]);
if (($truth(momentary) && (belt.momentary_factor == null))) {
(remedy = "Give momentary_factor in [belt] if the maker allows more while starting and braking; else take a stronger belt.");
(otherwise = "");
}
(share = ($mul(100.0, value) / $mul(belt.rating, belt.width)));
return of_drive__judged(rule, title, value, limit, "force", place, ("" + "rating of the belt" + $str(((!$eq(factor, 1.0)) ? ("" + " times " + $format(factor, ("" + "g"))) : "")) + ": " + $str(of_drive__origin($m.get(belt.sources, "rating", $bound(belt, "provenance"))))), ("" + "The belt tension {value} is {share} % of the rating of the belt and more than " + $str(said) + " allows, {limit}."), remedy, otherwise, "over belt rating", undefined, undefined, undefined, $map([["share", [share, "number"]]]));
}
function rules__tension_rule(kind) {

return $at($c46, (($eq(kind, "running")) ? "belt_tension" : "momentary_tension"));
}
function rules__tension_factor(belt, kind) {

return (($eq(kind, "running")) ? 1.0 : $or(belt.momentary_factor, () => 1.0));
}
function of_drive__origin(provenance) {

return $b.str(provenance);
}
function of_drive__belt_safety(drive, case_, pulley) {
let largest, tensions;

(tensions = $at(case_.tensions, pulley.name));
(largest = $b.max($bound(tensions, "entry"), $bound(tensions, "exit")));
return of_drive__safety_factor($bound(drive, "belt"), $bound(case_, "kind"), largest, new Place($bound(pulley, "name"), $bound(case_, "name")));
}
function of_drive__safety_factor(belt, kind, tension, place) {
let asked, factor, momentary, rule, source, strength, title, why;

([rule, momentary] = [$at($c46, "belt_safety"), (!$eq(kind, "running"))]);
(title = ("" + "Safety factor of the belt, " + $str(($truth(momentary) ? "momentary" : "running"))));
([strength, asked, factor] = [belt.breaking_strength, rules__asked_safety(belt, kind), ""]);
if ((strength == null)) {
return of_drive__not_checked($bound(rule, "name"), title, "the strength of the belt is not given", place);
}
if ($truth($math.isnan(asked))) {
(why = "neither rating nor kind of the belt tells what it is to be");
return of_drive__not_checked($bound(rule, "name"), title, why, place);
}
if (($truth(momentary) && (belt.momentary_factor != null))) {
(factor = ("" + " over momentary_factor, " + $format(belt.momentary_factor, ("" + "g"))));
}
(source = ("" + "customary for " + $str(belt.kind) + ", by works that follow DIN 22101" + $str(factor)));
if ((belt.rating != null)) {
(rule = $replaced(rule, new Map([["missed", "FAILS"]])));
(source = ("" + "strength over rating of the belt" + $str(factor) + ": " + $str(of_drive__origin(belt.source_of("rating")))));
}
return of_drive__judged(rule, title, numbers__safety_of($mul(strength, belt.width), tension, asked), asked, "number", place, source, "The strength of the belt is {value} times its tension, and is to be {limit} times.", "Lower the slack-side tension as far as the other checks allow, or take a wider or stronger belt.", "Take a wider or stronger belt.", "belt safety factor", "No belt is rated at more than a third of its strength.", undefined, (belt.rating != null));
}
function rules__asked_safety(belt, kind) {
let asked;

if ((belt.breaking_strength == null)) {
return NaN;
}
(asked = $m.get($c53, $bound(belt, "kind"), NaN));
if ((belt.rating != null)) {
(asked = (belt.breaking_strength / belt.rating));
}
return (asked / rules__tension_factor(belt, kind));
}
function numbers__safety_of(strength, tension, asked) {
let safety;

(safety = (strength / tension));
return (((safety < asked) && $truth(numbers__same_shown(tension, (strength / asked)))) ? asked : safety);
}
function of_drive__face_pressure(drive, case_, pulley) {
let belt, place, tensions, tight, title, value, why;

([belt, title] = [drive.belt, "Pressure on the pulley face"]);
(place = new Place($bound(pulley, "name"), $bound(case_, "name")));
if ((belt.largest_wrap_pressure == null)) {
(why = "the largest wrap pressure of the belt is not given");
return of_drive__not_checked("face_pressure", title, why, place);
}
(tensions = $at(case_.tensions, pulley.name));
(tight = $b.max($bound(tensions, "entry"), $bound(tensions, "exit")));
(value = rules__wrap_pressure(tight, $bound(belt, "width"), $bound(pulley, "diameter"), pitch__centrifugal_of(belt)));
return of_drive__judged($at($c46, "face_pressure"), title, value, $bound(belt, "largest_wrap_pressure"), "pressure", place, of_drive__origin($m.get(belt.sources, "largest_wrap_pressure", $bound(belt, "provenance"))), "The belt presses on the pulley face with {value}, more than the {limit} that it may.", "Take a larger or wider pulley, or less tension.", "Take a larger or wider pulley.", "face pressure");
}
function rules__wrap_pressure(tension, width, diameter, centrifugal) {

return ($mul(2.0, $sub(tension, centrifugal)) / $mul(width, diameter));
}
function* of_arc__lagging_stress(pulley, result) {
let fatigue, more, often, pitch, place;

(place = new Place($bound(pulley, "name"), $bound(result.arc, "load_case")));
yield of_arc___known(of_arc__bond(pulley, $bound(result, "peak_shear_stress"), place), result);
(often = "");
(more = $map([]));
if ((result.arc.belt_speed != null)) {
(often = ", {passes} times an hour,");
(pitch = $add(result.arc.radius, result.arc.offset));
$put(more, "passes", [pitch__turns_an_hour($bound(result.arc, "belt_speed"), pitch), "number"]);
}
(fatigue = of_arc___stress(pulley, $bound(result, "peak_shear_stress"), place, "fatigue_stress", "fatigue_limit", "Shear stress of lagging and bond, at every pass", "lagging tires", ("" + "At every pass of the belt" + $str(often) + " the shear stress rises to {value}, more than the fatigue limit {limit}."), more));
yield of_arc___known(fatigue, result);
}
function of_arc__bond(pulley, stress, place) {
let title;

(title = "Shear stress of lagging and bond, steady");
if ($truth(place.event)) {
(title = "Largest shear stress of lagging and bond");
}
return of_arc___stress(pulley, stress, place, "bond_stress", "bond_strength", title, "bond overstressed", "The shear stress of lagging and bond, {value}, is more than the {limit} that they bear.");
}
function of_arc___stress(pulley, stress, place, name, key, title, short, says, more = null) {
let lagging, limit, why;
(lagging = pulley.lagging);
(limit = $b.getattr(lagging, key));
if ((limit == null)) {
(why = ("" + "the " + $str($m.replace(key, "_", " ")) + " of lagging " + $str(lagging.name) + " is not given"));
return of_drive__not_checked(name, title, why, place);
}
return of_drive__judged($at($c46, name), title, stress, limit, "pressure", place, of_drive__origin(lagging.source_of(key)), says, "Choose a lagging with a stronger bond, a larger pulley, or less pull.", undefined, short, undefined, undefined, undefined, more);
}
function of_arc___known(check, result) {

if (($truth($told($c40, result.status, "solved")) || (check.level === "NOT CHECKED"))) {
return check;
}
return of_drive__not_checked($bound(check, "name"), $bound(check, "title"), of_arc__no_state(result), $bound(check, "place"));
}
function pitch__turns_an_hour(speed, pitch) {

return ($mul(3600.0, speed) / $mul($mul(2.0, 3.141592653589793), pitch));
}
function* of_drive__tested_pressure(drive, case_, pulley) {
let limit, more, name, of_tension, otherwise, place, tension, tensions, tested, title, why;

(tested = pulley.lagging.law.tested);
(place = new Place($bound(pulley, "name"), $bound(case_, "name")));
if ((tested == null)) {
(why = "the friction law states no tests");
yield of_drive__not_checked("tested_pressure", "Wrap pressure within the tests", why, place);
return null;
}
(tensions = $at(case_.tensions, pulley.name));
for ([name, title, tension, limit, of_tension, otherwise] of $iter([["tested_pressure_max", "Largest wrap pressure, tested", $b.max($bound(tensions, "entry"), $bound(tensions, "exit")), tested.pressure_max, "Lower the tension, take", "Take a larger or wider pulley, or test the lagging at this pressure."], ["tested_pressure_min", "Least wrap pressure, tested", $b.min($bound(tensions, "entry"), $bound(tensions, "exit")), tested.pressure_min, "Raise the slack-side tension, or test", "Test the lagging at this pressure."]])) {
(more = ($truth($at($c46, name).at_most) ? "above" : "below"));
yield of_drive__judged($at($c46, name), title, rules__wrap_pressure(tension, $bound(drive.belt, "width"), $bound(pulley, "diameter"), pitch__centrifugal_of($bound(drive, "belt"))), limit, "pressure", place, of_drive__tests_of(pulley), ("" + "The wrap pressure {value} is " + $str(more) + " the {limit} that lagging " + $str(check__escaped($bound(pulley.lagging, "name"))) + " was tested to: there the friction is an extrapolation."), ("" + $str(of_tension) + $str($slice(otherwise, 4, null))), otherwise, ("" + "pressure " + $str(more) + " tests"));
}
}
function of_drive__tests_of(pulley) {

return ("" + "tests of lagging " + $str(pulley.lagging.name) + ": " + $str(of_drive__origin(pulley.lagging.source_of("law"))));
}
function* of_data__condition(case_, pulley) {
let _, grounds, lagging, of, says;

(lagging = pulley.lagging);
if (($in("condition", lagging.sources))) {
([grounds, _] = of_data__law_words(lagging));
(of = (($in("untested", grounds)) ? "one without tests" : "a tested one"));
(of = (($in("illustrative", grounds)) ? "an illustrative one" : of));
(says = ("" + "its law is " + $str(of) + " scaled as a whole (" + $str($at(lagging.notes, $neg(1))) + ")"));
yield of_data___untested(case_, pulley, $bound(lagging, "condition"), "condition", says);
}
if (($in("worn", lagging.sources))) {
(says = "its law is that of before, and what wear takes off the friction is not known");
yield of_data___untested(case_, pulley, "worn", "worn", says);
}
}
function of_data___untested(case_, pulley, state, part, says) {
let lagging;
(lagging = pulley.lagging);
return new Check($at($c46, "condition").name, ("" + "Friction of " + $str(lagging.name) + ", " + $str(state)), "ATTENTION", new Place($bound(pulley, "name"), $bound(case_, "name")), undefined, undefined, undefined, undefined, of_drive__origin($at(lagging.sources, part)), ("" + "not tested " + $str(state)), check__escaped(("" + "Lagging " + $str(lagging.name) + " was not tested " + $str(state) + ": " + $str(says) + ".")), ("" + "Test the lagging " + $str(check__escaped(state)) + ", or keep more slack-side tension in hand."), ("" + "Test the lagging " + $str(check__escaped(state)) + "."), undefined, false);
}
function* of_data__fit(case_, pulley) {
let first, lagging, more, others;

(lagging = pulley.lagging);
if (((lagging.fit == null) || !$truth(lagging.fit.misfit))) {
return null;
}
([first, ...more] = lagging.fit.misfit);
(others = ($truth(more) ? ("" + " (and " + $str($b.len(more)) + " more of its lagging file)") : ""));
yield new Check($at($c46, "fit").name, ("" + "Friction of " + $str(lagging.name) + ", fit to its tests"), "ATTENTION", new Place($bound(pulley, "name"), $bound(case_, "name")), undefined, undefined, undefined, undefined, of_drive__origin($m.get(lagging.sources, "law", $bound(lagging, "provenance"))), "does not fit its tests", check__escaped(("" + "The friction law of lagging " + $str(lagging.name) + " does not describe its tests: " + $str($m.rstrip(first, ".")) + $str(others) + "." + $str(of_data___accepted($bound(lagging.fit, "misfit_accepted"))))), "Mend or repeat those tests and fit again, or keep more slack-side tension in hand.", "Mend or repeat those tests and fit again.", undefined, false);
}
function of_data___accepted(reason) {
return ($truth(reason) ? ("" + " The laboratory wrote it nevertheless: " + $str($m.rstrip(reason, ".")) + ".") : "");
}
function* of_arc__tested_slip(pulley, result) {
let check, place, slip, speed;

(place = new Place($bound(pulley, "name"), $bound(result.arc, "load_case")));
(slip = Infinity); (speed = slip);
if ($truth($told($c40, result.status, "solved"))) {
([slip, speed] = [in_page_checks__largest_slip(result), in_page_checks__slip_speed(result)]);
} else {
if ((result.arc.belt_speed == null)) {
(speed = NaN);
}
}
for (check of $iter(of_arc__slip_in_tests(pulley, slip, speed, place))) {
yield of_arc___known(check, result);
}
}
function in_page_checks__largest_slip(result) {

return result.found.largest_slip;
}
function in_page_checks__slip_speed(result) {

return result.found.slip_speed;
}
function* of_arc__slip_in_tests(pulley, slip, speed, place) {
let found, tested, title, unchecked, why;

(tested = pulley.lagging.law.tested);
if ((tested == null)) {
return null;
}
yield of_drive__judged($at($c46, "tested_slip"), "Largest slip, tested", slip, $bound(tested, "slip_max"), "length", place, of_drive__tests_of(pulley), ("" + "The slip {value} is beyond the {limit} that lagging " + $str(check__escaped($bound(pulley.lagging, "name"))) + " was tested to: there the friction is an extrapolation."), "Raise the slack-side tension, or test the lagging to this slip.", "Test the lagging to this slip.", "slip beyond tests");
(title = "Slip speed, tested");
if ((tested.slip_speed == null)) {
(why = "the friction law does not say at which speed it was tested");
(unchecked = of_drive__not_checked("tested_slip_speed", title, why, place));
(found = ($truth($math.isfinite(speed)) ? speed : NaN));
yield $replaced(unchecked, new Map([["value", found], ["dimension", "speed"]]));
} else {
if ($truth($math.isnan(speed))) {
yield of_drive__not_checked("tested_slip_speed", title, "the belt speed is not given", place);
} else {
yield of_drive__judged($at($c46, "tested_slip_speed"), title, speed, $bound(tested, "slip_speed"), "speed", place, of_drive__tests_of(pulley), ("" + "The belt slips at up to {value}, where the tests of lagging " + $str(check__escaped($bound(pulley.lagging, "name"))) + " ran at {limit}: how its friction changes with speed is not known."), "Test the lagging at this speed, or keep a larger safety factor.", undefined, "slips faster than tests", undefined, undefined, false);
}
}
}
function of_drive__sense(case_, pulley) {
let none, tensions, told;

(tensions = $at(case_.tensions, pulley.name));
(none = numbers__idles($bound(tensions, "entry"), $bound(tensions, "exit")));
(told = ($truth(none) ? "pulls nothing (T1 = T2)" : "brakes (T1 < T2)"));
return new Check("sense", ("" + "Pulley " + $str(pulley.name) + " " + $str(told)), "OK", new Place($bound(pulley, "name"), $bound(case_, "name")), undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
function of_arc__balance(result) {
let arc, error, g, pull, value;

(error = result.energy.identity_error);
if ((!$truth($told($c40, result.status, "solved")) || $truth($math.isnan(error)))) {
return null;
}
(arc = result.arc);
([pull, g] = [result.effective_tension, result.entry_creep_ratio]);
(value = numbers__balance_miss(error, pull, g, $bound(arc, "entry_tension"), $bound(arc, "compliance")));
return of_drive__judged($at($c46, "balance"), "Energy balance of the solution", value, 0.0001, "number", new Place($bound(arc, "pulley"), $bound(arc, "load_case")), "tolerance of the program", "The energy balance of the solution misses by {value}, more than {limit}.", "Please report the drive file; until then change a value slightly.", undefined, "out of balance", undefined, undefined, false);
}
function numbers__balance_miss(error, pull, g, entry, compliance) {
let exact, scale, told;

(exact = $b.abs($mul(pull, $add(g, $mul($mul(0.5, pull), compliance)))));
(told = $b.max(exact, $mul($mul(1e-06, entry), $b.abs(g)), 1e-300));
(scale = $b.max(exact, $mul($mul(1e-06, entry), $add($b.abs(g), $mul(entry, compliance)))));
return ((scale > 0.0) ? ($mul($b.abs(error), told) / scale) : 0.0);
}
function of_drive__sag(drive, case_) {
let driving, first, last, tension;

([first, last] = (function* () { for (const p of $iter([$at(drive.pulleys, 0), $at(drive.pulleys, $neg(1))])) { yield $at(case_.tensions, p.name); } })());
(driving = (first.entry >= last.exit));
(tension = ($truth(driving) ? last.exit : first.entry));
return of_drive__sags(drive, tension, new Place($bound($at(drive.pulleys, ($truth(driving) ? $neg(1) : 0)), "name"), $bound(case_, "name")));
}
function of_drive__sags(drive, tension, place) {
let limits, title;

([title, limits] = ["Slack-side tension, for sag", drive.criteria.sag]);
if ((limits == null)) {
return of_drive__not_checked("sag", title, "idler spacing and mass are not given", place);
}
return of_drive__judged($at($c46, "sag"), title, tension, $bound(limits, "tension"), "force", place, limits.SOURCE, ("" + "The slack side, {value}, sags more than " + $format($mul(100.0, limits.share), ("" + "g")) + " % of the idler spacing, which takes {limit}."), "Raise the slack-side tension, or set the idlers closer.", "Set the idlers closer.", "sags");
}
function* in_page_checks__across(_result) {

yield* $iter([]);
}
function* of_drive__take_up(drive) {
let after, case_, first, fixed, held, high, kind, last, low, ordered, what;

(kind = drive.criteria.take_up.kind);
if ((!$truth(kind) || (drive.conveyor != null))) {
return null;
}
(fixed = drive.criteria.take_up.fixed);
(held = $map([]));
for (case_ of $iter(drive.load_cases)) {
([first, last] = (function* () { for (const p of $iter([$at(drive.pulleys, 0), $at(drive.pulleys, $neg(1))])) { yield $at(case_.tensions, p.name); } })());
$put(held, case_.name, ($truth(fixed) ? $add(first.entry, last.exit) : drive.take_up_tension(case_)));
}
(ordered = alike__falling(held, ((name) => $at(held, name))));
([high, low] = [$at(ordered, 0), $at(ordered, $neg(1))]);
if ($truth(numbers__held_alike($at(held, low), $at(held, high)))) {
return null;
}
(after = drive.criteria.take_up.after);
(what = ($truth(fixed) ? "the sum of both tensions" : "the slack-side tension"));
(what = ($truth(after) ? ("" + "the tension behind pulley " + $str(check__escaped(after))) : what));
yield new Check("take_up", "Tensions that the take-up holds", "ATTENTION", undefined, undefined, undefined, undefined, undefined, ("" + "take-up " + $str(kind) + ", as given"), "contradicts take-up", ("" + "A " + $str(kind) + " take-up holds " + $str(what) + ", and it is {least} in load case " + $str(check__escaped(low)) + " and {most} in load case " + $str(check__escaped(high)) + "."), "Correct the tensions, or the kind under [take_up].", undefined, $map([["least", [$at(held, low), "force"]], ["most", [$at(held, high), "force"]]]), false);
}
function alike__falling(items, key) {
let every, numbers, rounded, step;

(every = $b.list(items));
(numbers = [...(function* () { for (const item of $iter(every)) { yield key(item); } })()]);
(step = $mul(1e-09, $b.max((function* () { for (const n of $iter(numbers)) { if (!(($b.abs(n) < Infinity))) continue; yield $b.abs(n); } })(), $k({default: 0.0}))));
(rounded = [...(function* () { for (const n of $iter(numbers)) { yield (($truth(step) && ($b.abs(n) < Infinity)) ? $b.round((n / step)) : n); } })()]);
return [...(function* () { for (const i of $iter($b.sorted($b.range($b.len(every)), $k({key: ((i) => $neg($at(rounded, i)))})))) { yield $at(every, i); } })()];
}
function numbers__held_alike(least, most) {

return ($sub(most, least) <= $mul(0.1, most));
}
function of_drive__pulley_diameter(drive, pulley) {
let belt, ends, least, title, why;

([belt, title, why] = [drive.belt, "Pulley diameter, least for the belt", ""]);
(ends = [...(function* () { for (const case_ of $iter(drive.load_cases)) { yield $at(case_.tensions, pulley.name); } })()]);
(least = belt.least_pulley_diameter);
if ((least == null)) {
(why = "the least pulley of the belt is not given");
} else {
if ($truth($b.all((function* () { for (const at of $iter(ends)) { yield numbers__idles($bound(at, "entry"), $bound(at, "exit")); } })()))) {
(why = "that of the belt is the least drive pulley, and this one pulls nothing");
}
}
if (($truth(why) || (least == null))) {
return of_drive__not_checked("pulley_diameter", title, why, new Place($bound(pulley, "name")));
}
return of_drive__judged($at($c46, "pulley_diameter"), title, $bound(pulley, "diameter"), least, "length", new Place($bound(pulley, "name")), of_drive__origin($m.get(belt.sources, "least_pulley_diameter", $bound(belt, "provenance"))), ("" + "Pulley " + $str(check__escaped($bound(pulley, "name"))) + ", {value}, is smaller than the least drive pulley of belt " + $str(check__escaped($bound(belt, "name"))) + ", {limit}."), "Take a larger pulley, or a belt that bends over this one.", undefined, "pulley too small");
}
function* in_page_checks__usual_sizes(_drive, ..._others) {

yield usual__all_usual();
}
function usual__all_usual() {
let title;

(title = "What is given is of usual size");
return new Check("usual_sizes", title, "OK", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
function of_data__data(drive, pulley) {
let found, grounds, kind, lagging, what, words, worst;

(lagging = pulley.lagging);
(found = $map([]));
for ([kind, what] of $iter(of_data__weak_sources(drive, pulley))) {
$m.append($m.setdefault(found, kind, []), what);
}
([grounds, words] = of_data__law_words(lagging));
(words = $add(words, [...(function* () { for (const kind of $iter($c42)) { if (!(($in(kind, found)))) continue; yield ("" + $str($m.capitalize(kind)) + ": " + $str($m.join(", ", $b.fromkeys($at(found, kind)))) + "."); } })()]));
(worst = $b.next((function* () { for (const [kind, word] of $iter($m.items($c54))) { if (!(($in(kind, [...$iter(grounds), ...$iter(found)])))) continue; yield word; } })(), ""));
return new Check("data", "Data that the answer stands on", "OK", new Place($bound(pulley, "name")), undefined, undefined, undefined, undefined, undefined, worst, check__escaped($m.join(" ", words)), undefined, undefined, undefined, false);
}
function least_tension__least_tension(result) {
let one;

if (($truth($b.isinstance(result, TrainResult)) && $truth(result.adrift))) {
return null;
}
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
if ((!$in(one, $c55))) {
$put($c55, one, least_tension___of(one));
}
return $at($c55, one);
}
function least_tension___of(result) {
let drive, either, ends, figure, found, given, held, take_up, weight, worst;
(drive = result.drive);
(ends = $map([...(function* () { for (const case_ of $iter(drive.load_cases)) { yield [case_.name, drive.take_up_tension(case_)]; } })()]));
if ($truth($b.any((function* () { for (const a of $iter(result)) { yield $and(least_tension___pulls(a), () => $math.isnan($bound(a.capacities, "gross_slip_capacity"))); } })()))) {
return null;
}
(worst = $map([]));
for (figure of $iter(least_tension__figures(result))) {
(held = $m.get(worst, $bound(figure, "name")));
(either = ((held == null) ? [figure] : [held, figure]));
$put(worst, figure.name, ($truth(figure.at_least) ? alike__largest : alike__least)(either, least_tension___tension));
}
if (!$truth($b.any((function* () { for (const f of $iter($m.values(worst))) { yield $and(f.at_least, () => f.binding); } })()))) {
return null;
}
(found = new LeastTension($b.tuple($m.values(worst)), 0.0, 0.0));
([given, take_up] = [$at(ends, found.governing.place.load_case), found.tension]);
if ((drive.conveyor != null)) {
(take_up = $sub($add(drive.conveyor.take_up, take_up), given));
}
(weight = drive.criteria.take_up.counterweight(take_up));
return new LeastTension($bound(found, "figures"), given, weight);
}
function least_tension___pulls(result) {
return !$truth(rules__idle($bound(result, "arc")));
}
function* least_tension__figures(result) {
let arcs, case_, drive, name;

(drive = result.drive);
for ([name, arcs] of $iter($m.items(least_tension___by_case(result)))) {
(case_ = drive.load_case(name));
yield* $iter(least_tension___figures(drive.in_case(case_), case_, arcs, drive.take_up_tension(case_)));
}
}
function least_tension___by_case(result) {
let arc, by_case;
(by_case = $map([]));
for (arc of $iter(result)) {
$m.append($m.setdefault(by_case, $bound(arc.arc, "load_case"), []), arc);
}
return by_case;
}
function* least_tension___figures(drive, case_, arcs, end) {
let arc, index, least, lift, offset, place, result, slack, tight;

for ([index, result] of $iter($b.enumerate(arcs))) {
([arc, place] = [result.arc, new Place($bound(result.arc, "pulley"), $bound(case_, "name"))]);
(tight = $b.max($bound(arc, "entry_tension"), $bound(arc, "exit_tension")));
(slack = $b.min($bound(arc, "entry_tension"), $bound(arc, "exit_tension")));
(offset = $sub(end, slack));
if ($truth(least_tension___pulls(result))) {
(least = result.capacities.least_exit_tension);
yield new Figure("creep", "Creep", $add(offset, ($truth($math.isnan(least)) ? Infinity : least)), place);
yield* $iter(least_tension___slip(result, offset, place));
yield* $iter(least_tension___standard(drive, case_, result, offset, place));
yield least_tension___gross_slip(drive, case_, arcs, index, end);
}
yield* $iter(least_tension___pressures(drive, case_, arc, $sub(end, slack), $sub(end, tight), place));
}
if ((drive.criteria.sag != null)) {
(place = new Place("", $bound(case_, "name")));
(lift = $sub(end, drive.slack_end(case_)));
yield new Figure("sag", "Belt sag", $add(drive.criteria.sag.tension, lift), place);
}
}
function* least_tension___slip(result, offset, place) {
let least, tested;

(tested = result.arc.law.tested);
if (((tested != null) && (tested.slip_max < result.arc.creep_limit))) {
(least = in_page_checks__least_with_slip(result, $bound(tested, "slip_max")));
yield new Figure("tested_slip", "Largest slip, tested", $add(offset, least), place);
}
}
function in_page_checks__least_with_slip(result, _limit) {

return result.found.least_for_slip;
}
function* least_tension___standard(drive, case_, result, offset, place) {
let binding, criteria, lagging, rule, tension;
([criteria, lagging] = [drive.criteria, drive.pulley($bound(result.arc, "pulley")).lagging]);
(rule = design_standard__asked($bound(criteria, "standard"), $bound(criteria, "take_up"), lagging, $bound(result.arc, "wrap_angle")));
if ((rule == null)) {
return null;
}
([binding, tension] = [criteria.standard.binding, Infinity]);
if (!$truth($math.isnan($bound(rule, "wrap_factor")))) {
(tension = $add(offset, of_arc__design_slack(drive, case_, result, $bound(rule, "wrap_factor"))));
} else {
if (!($truth(binding) && $truth(criteria.standard.name))) {
return null;
}
}
yield new Figure("design_standard", $bound(rule, "rule"), tension, place, binding);
}
function least_tension___gross_slip(drive, case_, arcs, index, end) {
let arc, factor, raised, rise, title;

([arc, factor] = [$at(arcs, index).arc, drive.criteria.safety.of($bound(case_, "kind"))]);
(rise = gross_slip__rises([...(function* () { for (const r of $iter(arcs)) { yield r.arc; } })()], index, $bound(drive.criteria, "take_up")));
(raised = in_page_checks__lift($at(arcs, index), factor, $bound(rise, "tight")));
(title = ("" + "Safety " + $format(factor, ("" + "g")) + " against gross slip"));
(raised = ($truth($math.isnan(raised)) ? Infinity : raised));
return new Figure("gross_slip", title, $add(end, raised), new Place($bound(arc, "pulley"), $bound(case_, "name")));
}
function in_page_checks__lift(result, _factor, _tight_rise) {

return result.found.lift;
}
function* least_tension___pressures(drive, case_, arc, of_slack, of_tight, place) {
let area, belt, high, low, most, tested, title;
([belt, tested, area] = [drive.belt, arc.law.tested, $mul(arc.width, arc.radius)]);
if ((tested != null)) {
([low, high] = (function* () { for (const p of $iter([tested.pressure_min, tested.pressure_max])) { yield $add($mul(p, area), arc.centrifugal); } })());
yield new Figure("tested_pressure_min", "Least wrap pressure, tested", $add(of_slack, low), place);
(title = "Largest wrap pressure, tested");
yield new Figure("tested_pressure_max", title, $add(of_tight, high), place, undefined, false);
}
if ((belt.largest_wrap_pressure != null)) {
([title, most] = ["Pressure on the pulley face", $add($mul(belt.largest_wrap_pressure, area), arc.centrifugal)]);
yield new Figure("face_pressure", title, $add(of_tight, most), place, undefined, false);
}
if ((belt.rating != null)) {
(most = $add(of_tight, $mul($mul(rules__tension_factor(belt, $bound(case_, "kind")), belt.rating), belt.width)));
yield new Figure("belt_tension", "Belt tension", most, place, undefined, false);
}
}
function least_tension___tension(figure) {
return figure.tension;
}
function alike__largest(items, key) {
let every, found, item, most, number;

(every = [...(function* () { for (const item of $iter(items)) { yield [key(item), item]; } })()]);
if (!$truth(every)) {
throw new $ValueError("nothing to choose from");
}
([most, found] = $at(every, 0));
for ([number, item] of $iter($slice(every, 1, null))) {
if (((number > most) && !$truth($math.isclose(number, most, ({rel_tol: 1e-09}))))) {
([most, found] = [number, item]);
}
}
return found;
}
function alike__least(items, key) {

return alike__largest(items, ((item) => $neg(key(item))));
}
function judge__sound(checks, least) {
let both, missed, names;

(missed = [...(function* () { for (const c of $iter(checks)) { if (!($truth(c.missed))) continue; yield [c.name, c.place]; } })()]);
(names = new Set((function* () { for (const [name, _] of $iter(missed)) { yield name; } })()));
(both = $and($b.bool($common(names, $c56)), () => $b.bool($common(names, $c57))));
function advised(check) {
if (($in([$m.get($c58, $bound(check, "name"), ""), check.place], missed))) {
return $replaced(check, new Map([["remedy", "Mend first what the even pulley lacks: it fails too."]]));
}
if (($truth(check.missed) && $truth(check.otherwise) && !$truth(judge___helps(check, least, both)))) {
return $replaced(check, new Map([["remedy", check.otherwise]]));
}
return check;
}
$sig(advised, ["check"], false);
return $b.tuple($b.map(advised, checks));
}
function judge___helps(check, least, both) {
let own, too_much, top;

if ((least == null)) {
return !$truth(both);
}
(own = $b.next((function* () { for (const f of $iter(least.figures)) { if (!(($eq(f.name, check.name)))) continue; yield f; } })(), null));
if (((own == null) && $truth(both))) {
return false;
}
(top = least.highest);
(too_much = $and((own != null), () => $and((top != null), () => $and(own.at_least, () => (own.tension > top.tension)))));
return $and($math.isfinite($bound(least, "tension")), () => !$truth(too_much));
}
function judge___wet(result) {
let arc, condition, creep, drive, factor, most, over;

([most, over, drive] = [$neg(1.0), false, result.drive]);
for (arc of $iter(result)) {
(condition = drive.load_case($bound(arc.arc, "load_case")).condition);
(factor = of_data__wet_factor(drive.pulley($bound(arc.arc, "pulley")).lagging_in(condition)));
if (($eq(factor, 0.0))) {
return [$neg(1.0), false];
}
if (!$truth(rules__idle($bound(arc, "arc")))) {
(creep = in_page_checks__wet(arc, factor));
(most = ($truth($math.isnan(creep)) ? creep : $b.max(most, creep)));
(over = $or(over, () => !($truth($math.isnan(creep)) || $truth(numbers__kept(creep, $bound(arc.arc, "creep_limit"), true)))));
}
}
return [most, over];
}
function in_page_checks__wet(result, _factor) {

return result.found.wet;
}
function least_tension__least_sentence(result) {
let as_now, asked, described, found, given, governs, least, standard, text, what, why;

(found = least_tension__least_tension(result));
if ((found == null)) {
return "";
}
([least, given] = [least_tension__at_least($bound(found, "tension")), sheet__named("tension", $bound(found, "given"))]);
(governs = found.governing);
(why = $at($c46, governs.name).what);
if ($truth($math.isinf($bound(found, "tension")))) {
return least_tension___none(found, result);
}
(what = least_tension__least_name(result));
(as_now = ($truth(least_tension__divides_anew(result)) ? ", the load divided as it is," : ""));
(described = ($truth($b.isinstance(result, DriveResult)) ? result.drive : result.train));
if ($truth($b.any((function* () { for (const pulley of $iter(described.pulleys)) { yield pulley.across; } })()))) {
(as_now = $add(as_now, ", were the pulley even,"));
}
(text = ("" + "The least " + $str(what) + " with which every binding check is kept" + $str(as_now) + " is " + $str(least) + ", set by " + $str(why) + " (" + $str(governs.place) + "); given " + $str(given)));
(standard = found.standard);
if (((standard != null) && (found.tension < $mul(standard.tension, $sub(1.0, 1e-09))))) {
(asked = least_tension__at_least($bound(standard, "tension")));
(text = $add(text, ("" + "; that is below the " + $str(asked) + " that " + $str(standard.title) + " asks for")));
}
return ("" + $str(text) + ".");
}
function least_tension__at_least(tension) {

return cellOf(tension, "force", 3, "up", undefined, "tension");
}
function sheet__named(name, value) {

return cell__quantity(value, $bound(term(name), "dimension"), 3, name);
}
function least_tension___none(found, result) {
let asked, governs, most, top;
([governs, top] = [found.governing, found.highest]);
if (($truth($math.isinf($bound(governs, "tension"))) && ($eq(governs.name, "design_standard")))) {
return ("" + "No " + $str(least_tension__least_name(result)) + " keeps every binding check: " + $str(governs.title) + " cannot be applied (" + $str(governs.place) + ").");
}
if (($truth($math.isinf($bound(governs, "tension"))) || (top == null))) {
return ("" + "No " + $str(least_tension__least_name(result)) + " with wrap pressures in the tested range keeps " + $str($at($c46, governs.name).what) + " (" + $str(governs.place) + ").");
}
([asked, most] = [least_tension__at_least($bound(governs, "tension")), least_tension__at_most($bound(top, "tension"))]);
return ("" + "No " + $str(least_tension__least_name(result)) + " keeps every binding check: " + $str($at($c46, governs.name).what) + " asks for " + $str(asked) + " (" + $str(governs.place) + "), and " + $str($at($c46, top.name).what) + " allows " + $str(most) + " (" + $str(top.place) + ").");
}
function least_tension__least_name(result) {
let after;

(after = least_tension___after(result));
return ($truth(after) ? ("" + "tension at the take-up behind pulley " + $str(after)) : "slack-side tension");
}
function least_tension___after(result) {
let of;
(of = ($truth($b.isinstance(result, TrainResult)) ? result.train : result.drive));
return of.criteria.take_up.after;
}
function least_tension__at_most(tension) {

return cellOf(tension, "force", 3, "down", undefined, "tension");
}
function least_tension__divides_anew(result) {

return $and($b.isinstance(result, TrainResult), () => !$truth($b.all((function* () { for (const c of $iter(result)) { yield c.case.pulls_given; } })())));
}
function least_tension__least_table(result) {
let after, bound, figure, found, given, governs, least, note, rows, shown, symbol, text, weight, where;

(found = least_tension__least_tension(result));
if ((found == null)) {
return null;
}
([rows, after] = [[], least_tension___after(result)]);
if (!$truth($math.isinf($bound(found, "tension")))) {
(weight = cellOf($bound(found, "counterweight"), "mass", 3, "up"));
(given = ("" + "given " + $str(sheet__named("tension", $bound(found, "given")))));
(least = least_tension__at_least($bound(found, "tension")));
(symbol = ($truth(after) ? "" : "T2_min"));
$m.append(rows, new Row(("" + "Least " + $str(least_tension__least_name(result))), [least], symbol, given));
$m.append(rows, new Row("Counterweight for it", [weight], "", "if the take-up is a weight"));
}
for (figure of $iter($b.sorted($bound(found, "figures"), $k({key: ((f) => [!$truth(f.at_least), $neg(f.tension)])})))) {
(bound = ($truth(figure.at_least) ? "at least" : "at most"));
(shown = ($truth(figure.at_least) ? least_tension__at_least : least_tension__at_most));
(text = ($truth($math.isinf($bound(figure, "tension"))) ? "none" : shown($bound(figure, "tension"))));
(governs = (figure === found.governing));
(note = ($truth(governs) ? "governs" : ($truth(figure.binding) ? "" : "not binding")));
(note = $m.join(", ", (function* () { for (const part of $iter([note, $b.str($bound(figure, "place"))])) { if (!($truth(part))) continue; yield part; } })()));
$m.append(rows, new Row(("" + $str(figure.title) + ", " + $str(bound)), [text], "", note));
}
(where = ($truth(after) ? ("" + "at the take-up behind pulley " + $str(after)) : "of the slack side behind the drives"));
(note = ("" + "Tension " + $str(where) + " with which each check is kept, every pulley pulling as it does."));
return new Table(("" + "Least " + $str(least_tension__least_name(result))), $b.tuple(rows), undefined, note, "least");
}
function least_tension__shown_least(result) {
let found;

(found = least_tension__least_tension(result));
return ((found == null) ? "-" : ($truth($math.isinf($bound(found, "tension"))) ? "none" : least_tension__at_least($bound(found, "tension"))));
}
function checks_table__check_table(verdict, of = null, title = "Checks") {
let judged, rows;

(judged = [...(function* () { for (const c of $iter(verdict.listed)) { if (!($truth(c.compares))) continue; yield c; } })()]);
(rows = $b.tuple((function* () { for (const check of $iter(judged)) { yield checks_table___row(check, of); } })()));
return new Table(title, rows, ["found", "limit", "margin"], ("" + $str("Margin: how far the value is from its limit, over the limit; positive on the safe side. Each check is shown where it comes off worst.") + $str(checks_table___left(verdict))), "checks", checks_table___nearest(verdict, title), $m.strip(("" + $str(($truth(verdict.missed) ? ("" + $str(checks_table___counted(verdict)) + ". ") : "")) + $str(checks_table___unchecked(verdict)))));
}
function checks_table___row(check, of) {
let _, found, note, number, values;
([found, _] = check.texts());
(values = [$or(found, () => "-"), $or(check.bound(), () => "-"), checks_table__margin_text(check)]);
(number = ((of == null) ? "" : of.number($bound(check, "source"))));
(note = $m.join(" ", (function* () { for (const part of $iter([$b.str($bound(check, "place")), number])) { if (!($truth(part))) continue; yield part; } })()));
return new Row($bound(check, "title"), values, undefined, note, undefined, check.level);
}
function checks_table__margin_text(check) {
let margin;

(margin = check.margin);
if ($truth(check.below)) {
return "-";
}
if (!$truth($math.isnan($bound(check, "times")))) {
return ("" + $str(cell__quantity($bound(check, "times"), "number")) + " times the limit");
}
if (!$truth($math.isfinite(margin))) {
return "-";
}
if ((0.9995 <= margin && margin < $sub(1.0, 1e-09))) {
return "> +99.9 %";
}
if (($b.abs(margin) < 1e-09)) {
return "0 %";
}
return ("" + $format($mul(100.0, margin), ("" + "+.3g")) + " %");
}
function checks_table___left(verdict) {
let left, told;

(left = [...(function* () { for (const c of $iter(verdict.listed)) { if (!((c.level === "NOT CHECKED"))) continue; yield c; } })()]);
(told = (function* () { for (const c of $iter(left)) { yield ("" + $str($m.lower($slice(c.title, null, 1))) + $str($slice(c.title, 1, null)) + " (" + $str(checks_table___why(c)) + ")"); } })());
return ($truth(left) ? ("" + " Not checked: " + $str($m.join("; ", told)) + ".") : "");
}
function checks_table___why(check) {
let _, found;
([found, _] = check.texts());
return ($truth(found) ? ("" + $str(check.short) + "; here it is " + $str(found)) : check.short);
}
function checks_table___nearest(verdict, title) {
let rows, told;

(told = [...(function* () { for (const c of $iter(verdict.listed)) { if (!(($truth(c.compares) && ($truth(c.missed) || $truth($math.isfinite($bound(c, "margin"))))))) continue; yield c; } })()]);
(told = $b.sorted((function* () { for (const c of $iter(told)) { if (!(!$truth(c.below))) continue; yield c; } })(), $k({key: verdict.nearness})));
(rows = (function* () { for (const c of $iter($slice(told, null, $b.max(4, $b.len($bound(verdict, "missed")))))) { yield new Row($bound(c, "title"), [$or($at(c.texts(), 0), () => "-"), $or(c.bound(), () => "-")], "", $b.str($bound(c, "level"))); } })());
return new Table(title, $b.tuple(rows), ["found", "limit"], undefined, "checks");
}
function checks_table___counted(verdict) {
let judged;
(judged = [...(function* () { for (const c of $iter(verdict.listed)) { if (!($truth(c.compares))) continue; yield c; } })()]);
return ("" + $str($b.sum((function* () { for (const c of $iter(judged)) { yield !$truth(c.missed); } })())) + " of " + $str($b.len(judged)) + " checks are kept");
}
function checks_table___unchecked(verdict) {
let heads, left, told;
(left = [...(function* () { for (const c of $iter(verdict.listed)) { if (!((c.level === "NOT CHECKED"))) continue; yield c.title; } })()]);
(heads = [...(function* () { for (const title of $iter(left)) { yield $at($m.partition(title, ","), 0); } })()]);
(told = (function* () { for (const [head, title] of $iter($b.zip(heads, left, $k({strict: true})))) { yield (($m.count(heads, head) > 1) ? head : title); } })());
return ($truth(left) ? ("" + "Not checked: " + $str($m.join("; ", $b.fromkeys(told))) + ".") : "");
}
function words__short(result, arc) {
let worst;

if ((arc.status === "Breakaway: no creep makes enough friction for this tension ratio. Raise the slack-side tension (take-up), enlarge the wrap angle, or choose a lagging with more friction.")) {
return "breaks away";
}
(worst = judge__judge(result).at($bound(arc.arc, "pulley"), $bound(arc.arc, "load_case")).governing);
if (((worst != null) && $truth(worst.missed))) {
return worst.short;
}
return ($truth(rules__idle($bound(arc, "arc"))) ? "not driven" : "carries");
}
function words__alone_of(result, arc) {
let known;

(known = $m.setdefault($c59, result, $map([])));
if ((!$in(arc, known))) {
$put(known, arc, words__alone($bound(result, "drive"), arc));
}
return $at(known, arc);
}
function words__alone(drive, arc) {
let case_, name, own, pulley, solved, tensions;

([name, solved] = [arc.arc.load_case, arc.arc]);
(tensions = new Tensions(solved.entry_tension, solved.exit_tension));
(own = $b.next((function* () { for (const case_ of $iter(drive.load_cases)) { if (!(($eq(case_.name, name)))) continue; yield case_; } })(), null));
(case_ = new LoadCase(name, $map([[arc.arc.pulley, tensions]]), ($truth(own) ? own.kind : "running"), ($truth(own) ? own.condition : "")));
(pulley = drive.pulley($bound(arc.arc, "pulley")));
return new DriveResult($replaced(drive, new Map([["pulleys", [pulley]], ["load_cases", [case_]]])), [arc]);
}
function errors___stopped(sentence) {
return ((!$truth(sentence) || ($in($at(sentence, $neg(1)), ".?!"))) ? sentence : $add(sentence, "."));
}
function problems___renamed(key, names) {
let name, path, place, position;

(place = []);
(path = []);
for ([name, position] of $iter($m.findall($c60, key))) {
if ($truth(name)) {
$m.append(path, name);
$m.append(place, $m.get(names, $m.join(".", path), name));
} else {
$m.append(place, $b.int(position));
}
}
return $b.tuple(place);
}
function problems__value_at(raw, place) {
let step;

for (step of $iter(place)) {
if (($truth($b.isinstance(step, "int")) && $truth($b.isinstance(raw, "Sequence")) && (0 < step && step <= $b.len(raw)))) {
(raw = $at(raw, $sub(step, 1)));
} else {
if (($truth($b.isinstance(raw, "Mapping")) && ($in(step, raw)))) {
(raw = $at(raw, step));
} else {
return $c7;
}
}
}
return raw;
}
function lagging_build__build_laggings(record, report) {
let common, found, laws, made, notes, parts, sources;

(found = $b.len($bound(report, "problems")));
(sources = origins__read_sources(record, $c61, report));
(common = $map([...(function* () { for (const key of $iter($c62)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
$put(common, "provenance", $or(origins__own_provenance(record, report), () => new Provenance()));
$put(common, "cost", $c63.built($m.get(record, "cost"), report));
(common = $merged(common, lagging_build___elasticity(record, sources, $at(common, "provenance"), report)));
(laws = [...(function* () { for (const law of $iter($m.get(record, "law", []))) { if (!($truth($b.isinstance(law, Record)))) continue; yield law; } })()]);
(notes = $b.tuple($m.get(record, "notes", [])));
$put(common, "condition_factors", lagging_build___condition_factors(record, report));
(parts = [...(function* () { for (const law of $iter(laws)) { yield lagging_build___law_parts(law, record, sources, notes, report); } })()]);
lagging_build___check_conditions(laws, report);
if ((!$truth($m.get(record, "law")) && $truth(record.sound("law")))) {
report.add([...$iter(record.place), "law"], "missing", "Add a [law] table, as the examples show.");
}
if ((($b.len($bound(report, "problems")) > found) || !$truth(record.sound()))) {
return [];
}
(made = report.tried((() => $b.tuple((function* () { for (const part of $iter(parts)) { yield $call(Lagging, [], [...common, ...part]); } })())), $bound(record, "place"), $bound(record, "raw")));
return $or(made, () => []);
}
function lagging_build___elasticity(record, sources, provenance, report) {
let given, known, message, place, remedy, stated;

(given = [...(function* () { for (const key of $iter($c64)) { if (!(($in(key, record)))) continue; yield key; } })()]);
if (!$truth(record.sound("thickness", ...$iter($c64)))) {
return $map([]);
}
if ((!$in("thickness", record))) {
if ($truth(given)) {
(place = [...$iter(record.place), "thickness"]);
report.add(place, ("" + "missing, where " + $str($at(given, 0)) + " is given"), "Write thickness = \"12 mm\".");
}
return $map([]);
}
if ((($in("compression_modulus", record)) && ($in("block", record)))) {
(message = "given, and the compression modulus as well");
report.add([...$iter(record.place), "block"], message, "Keep one of them.");
return $map([]);
}
(known = $or(($in("elastic_modulus", record)), () => ($in("shear_modulus", record))));
if ((!$truth(known) && ($at(record, "thickness") > 0.0))) {
(place = [...$iter(record.place), "shear_modulus"]);
(remedy = "Give shear_modulus, or elastic_modulus, of which it is a third.");
report.add(place, "missing, and the lagging is not rigid", remedy);
return $map([]);
}
(stated = $map([...(function* () { for (const key of $iter($c65)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
return ($truth(known) ? $merged(lagging_build___estimated(record, sources, provenance, report), stated) : stated);
}
function lagging_build___estimated(record, sources, provenance, report) {
let basis, block, height, moduli, shape, text, young;

function note(part, basis, text) {
let of;
(of = $m.get(sources, basis, provenance));
$m.setdefault(sources, part, new Provenance($bound(of, "kind"), $bound(of, "source"), $bound(of, "date"), ("" + "estimated: " + $str(text))));
}
$sig(note, ["part", "basis", "text"], false);
(moduli = $map([]));
if ((!$in("shear_modulus", record))) {
$put(moduli, "shear_modulus", ($at(record, "elastic_modulus") / 3.0));
note("shear_modulus", "elastic_modulus", "G = E/3, incompressible rubber");
}
if ((!$in("compression_modulus", record))) {
(basis = (($in("elastic_modulus", record)) ? "elastic_modulus" : "shear_modulus"));
(young = $mul($at(record, basis), (($eq(basis, "elastic_modulus")) ? 1.0 : 3.0)));
(shape = $m.get(record, "block", $map([])));
(height = (($in("height", shape)) ? $map([]) : $map([["height", $at(record, "thickness")]])));
(block = $method($c66, "built", [shape, report], [...height]));
$put(moduli, "compression_modulus", ($truth(block) ? compression__compression_modulus(young, block) : young));
$put(moduli, "block", block);
(text = lagging_build___compression_note(block, (($eq(basis, "elastic_modulus")) ? "E" : "3 G")));
note("compression_modulus", (($in("block", sources)) ? "block" : basis), text);
}
return moduli;
}
function compression__compression_modulus(elastic_modulus, block) {
let square;

(square = ($eq(block.shape, "square")));
return compression__block_modulus(elastic_modulus, square, $bound(block, "width"), $bound(block, "height"), $bound(block, "stiffening"), $bound(block, "contact_fraction"));
}
function lagging_build___compression_note(block, modulus) {
if ((block == null)) {
return ("" + "E_c = " + $str(modulus) + ", no stiffening by the shape of blocks");
}
return ("" + "E_c from " + $str(modulus) + " and the shape of the blocks, Gent and Lindley (1959), " + $str(block.shape) + ", S = " + $format(block.shape_factor, ("" + ".3g")) + ", k = " + $format(block.stiffening, ("" + "g")) + ", contact fraction " + $format(block.contact_fraction, ("" + "g")));
}
function lagging_build___condition_factors(record, report) {
let found, row, source;
(found = $map([]));
for (row of $iter($m.get(record, "condition_factor", []))) {
if (($truth($b.isinstance(row, Record)) && $truth(row.sound()))) {
(source = origins__read_provenance($at(row, "provenance"), report));
$put(found, $at(row, "condition"), $method($c67, "built", [row, report], [["source", source]]));
}
}
return $map([...(function* () { for (const [name, factor] of $iter($m.items(found))) { if (!((factor != null))) continue; yield [name, factor]; } })()]);
}
function lagging_build___law_parts(law, record, sources, notes, report) {
let factors, own, parts, scaled, tested;

([own, scaled] = [origins__own_provenance(law, report), null]);
if ($truth($b.isinstance($m.get(law, "condition_source"), Record))) {
(scaled = origins__read_provenance($at(law, "condition_source"), report));
}
(parts = $map([["law", own], ["condition", scaled]]));
(tested = laws__read_law(law, report));
(factors = ((tested != null) ? lagging_build___factors(tested, law, record, report) : null));
if ((factors != null)) {
(parts = $merged(parts, factors.sources));
}
return $map([["law", ((factors != null) ? factors.used : tested)], ["factors", factors], ["condition", $m.get(law, "condition", "dry")], ["fit", $c74.built($m.get(law, "fit"), report)], ["notes", [...$iter(notes), ...$iter($m.get(law, "notes", []))]], ["sources", $merged(sources, $map([...(function* () { for (const [part, of] of $iter($m.items(parts))) { if (!($truth(of))) continue; yield [part, of]; } })()]))]]);
}
function laws__read_law(record, report) {
let error, kind, law, names;

if (!$truth(record.sound())) {
return null;
}
(kind = $at(record, "kind"));
(names = $merged($c68, $map([["pressure", $m.get($c69, kind, "tested_pressure")]])));
try {

if (($eq(kind, "integral-log"))) {
(law = laws___integral_log(record));
} else {
if (($eq(kind, "table"))) {
(law = laws___table(record));
} else {
(law = $method($c70, "built", [record, report], [["tested", laws___tested(record)]]));
}
}
if (((law != null) && ($in("slip_includes", record)))) {
(law = $replaced(law, new Map([["slip_includes", $b.tuple($b.fromkeys($at(record, "slip_includes")))]])));
}
return law;
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
report.take(error, $bound(record, "place"), $bound(record, "raw"), names);
return null;
} else throw $error;
}
}
function laws___tested(record, ends = null) {
let missing, pressures, slip, speed, there;

([pressures, slip] = [$m.get(record, "tested_pressure"), $m.get(record, "tested_slip")]);
(speed = $m.get(record, "tested_slip_speed"));
if ((ends != null)) {
if ((pressures != null)) {
throw laws___problem("tested_pressure", "the tested pressures are the ends of the knots or pieces", "Leave it out.", $shown($at(record.raw, "tested_pressure")));
}
(pressures = $b.list(ends));
}
if (((slip == null) && (speed != null))) {
throw laws___problem("tested_slip", "missing, where tested_slip_speed is given", "Give both.");
}
if (((slip == null) && ((pressures == null) || (ends != null)))) {
return null;
}
if (((pressures == null) || (slip == null))) {
([missing, there] = ["tested_pressure", "tested_slip"]);
if ((slip == null)) {
([missing, there] = [there, missing]);
}
throw laws___problem(missing, ("" + "missing, where " + $str(there) + " is given"), "Give both or none.");
}
return new TestedRange($at(pressures, 0), $at(pressures, 1), slip, speed);
}
function laws___problem(key, message, remedy = "", value = "") {
return new InputError(new Problem(message, remedy, undefined, key, value));
}
function laws___table(record) {
let problems, rows, slips;
(rows = $at(record, "rows"));
laws___check_order(rows, "rows");
(slips = $b.len($at(record, "slip")));
(problems = [...(function* () { for (const [number, row] of $iter($b.enumerate(rows, $k({start: 1})))) { if (!((!$eq($b.len($at(row, "friction")), slips)))) continue; yield new Problem(("" + $str($b.len($at(row, "friction"))) + " values for " + $str(slips) + " slips"), "Give one for each slip.", undefined, ("" + "rows[" + $str(number) + "].friction")); } })()]);
laws___raise(problems);
return new MeasuredTable(undefined, $b.tuple($at(record, "slip")), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $b.tuple($at(row, "friction")); } })()));
}
function laws___check_order(rows, key) {
let problems;

(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($at(row, "pressure") <= $at(before, "pressure")))) continue; yield new Problem(("" + "not above the pressure of the row before, " + $str($shown($at(before.raw, "pressure")))), "Write the rows in order of rising pressure.", undefined, ("" + $str(key) + "[" + $str(number) + "].pressure")); } })()]);
laws___raise(problems);
}
function laws___raise(problems) {
let found;
if ($truth((found = $b.list(problems)))) {
throw new InputError(found);
}
}
function laws___integral_log(record) {
let coefficients, found, p, tested;
if (($eq(($in("knots", record)), ($in("pieces", record))))) {
(found = (($in("knots", record)) ? "both knots and pieces" : "neither knots nor pieces"));
throw laws___problem("", ("" + "an integral-log law with " + $str(found)), "Give one of the two.");
}
if (($in("knots", record))) {
(coefficients = laws___knots(record));
} else {
(coefficients = laws___pieces(record));
}
(p = coefficients.pressure);
(tested = laws___tested(record, (($b.len(p) > 1) ? [$at(p, 0), $at(p, $neg(1))] : null)));
return new IntegralLog(undefined, coefficients, tested);
}
function laws___pieces(record) {
let error, more, number, pieces, pressure_unit, problems, row, rows, slip_unit;
(slip_unit = laws___unit(record, "slip_unit", "length", "mm"));
(pressure_unit = laws___unit(record, "pressure_unit", "pressure", "kPa"));
(rows = $at(record, "pieces"));
(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($b.abs($sub(($at(row, "from") / $at(before, "to")), 1.0)) > 1e-09))) continue; yield new Problem(("" + "not where the piece before ends, " + $str($shown($at(before.raw, "to")))), "Let the pieces follow each other without gap or overlap.", undefined, ("" + "pieces[" + $str(number) + "].from")); } })()]);
(pieces = []);
for ([number, row] of $iter($b.enumerate(rows, $k({start: 1})))) {
try {
$m.append(pieces, laws___piece(row, slip_unit, pressure_unit));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield new Problem(p.message, p.remedy, undefined, ("" + "pieces[" + $str(number) + "]." + $str(p.key))); } })()]));
} else throw $error;
}
}
laws___raise(problems);
(more = (($in("continuity", record)) ? $map([["continuity", $at(record, "continuity")]]) : $map([])));
return $call(CoefficientPieces, [], [["pressure", [...$iter((function* () { for (const row of $iter(rows)) { yield $at(row, "from"); } })()), $at($at(rows, $neg(1)), "to")]], ["pieces", $b.tuple(pieces)], ["slip_unit", slip_unit], ...more]);
}
function laws___unit(record, key, dimension, example) {
let error, remedy, unit;
if ((!$in(key, record))) {
(remedy = ("" + "Write " + $str(key) + " = \"" + $str(example) + "\" or the unit that A and b were fitted in."));
throw laws___problem(key, "missing, and A and b mean nothing without it", remedy);
}
(unit = $at(record, key));
try {
return parse__unit_factor(unit, dimension);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(remedy = ("" + "Write for example \"" + $str(example) + "\"."));
throw laws___problem(key, $bound($at(error.problems, 0), "message"), remedy);
} else throw $error;
}
}
function laws___piece(row, slip_unit, pressure_unit) {
let error, factors, key, problems, trends;

(trends = $map([]));
(problems = []);
if ((($in("post_peak_slope", row)) && (!$in("residual_friction", row)))) {
$m.append(problems, laws___useless_slope("residual_friction"));
}
(factors = $map([["A", 1.0], ["b", 1.0], ["post_peak_slope", (1.0 / slip_unit)], ["residual_friction", 1.0]]));
for (key of $iter([...(function* () { for (const key of $iter(factors)) { if (!(($in(key, row)))) continue; yield key; } })()])) {
try {
$put(trends, $m.lower(key), trends__read_trend($at(row, key), pressure_unit, $at(factors, key)));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield new Problem(p.message, p.remedy, undefined, key); } })()]));
} else throw $error;
}
}
laws___raise(problems);
return $call(Piece, [], [...trends]);
}
function laws___useless_slope(key) {
return new Problem("missing, and without it friction stays at its peak, whatever the slope", "Give the level that friction falls to.", undefined, key);
}
function trends__read_trend(text, pressure_unit = 1.0, factor = 1.0) {
let exponent, single, terms, trend;

(terms = trends___terms(text));
(single = (($eq($b.len(terms), 1)) ? $at(terms, 0) : null));
if (($truth(single) && (single.exponent != null))) {
(trend = trends___scaled_exponent($bound(single, "exponent"), $mul(single.coefficient, $b.Decimal(factor)), text));
} else {
if (($truth(single) && ($eq(single.function, "p")) && (!$in(single.power, [0, 1, 2, 3])))) {
(exponent = new Trend("logarithmic", [0.0, single.power]));
(trend = trends___scaled_exponent(exponent, $mul(single.coefficient, $b.Decimal(factor)), text));
} else {
(trend = trends___sum(terms, text, $b.Decimal(factor)));
}
}
return trends___over_pascal(trend, pressure_unit);
}
function trends___terms(text) {
let match, pattern, position, terms;
(pattern = $once(trends___grammar, $kept_trends___grammar)());
(terms = []);
(position = 0);
while ((position < $b.len(text))) {
(match = $m.match(pattern, text, position));
if (((match == null) || ($eq($m.end(match), position)))) {
throw trends___refused(text, "no equation over the pressure p");
}
if ((!($truth($at(match, "number")) || $truth($at(match, "factor"))) || ($truth(terms) && !$truth($at(match, "sign"))))) {
throw trends___refused(text, "no equation over the pressure p");
}
$m.append(terms, trends___term(match, text));
(position = $m.end(match));
}
if (!$truth(terms)) {
throw trends___refused(text, "empty, where an equation is needed");
}
return terms;
}
function trends___grammar() {

return $c71;
}
const $kept_trends___grammar = new Map();
function trends___refused(text, message) {
return new InputError(new Problem(message, "Write it over the pressure p as a polynomial (0.12 - 0.00021 p + 1.4e-7 p^2), a logarithm (-0.31 + 0.042 ln(p)), a power (-1.6 p^-0.45) or an exponential (-0.2 exp(-0.0031 p)).", undefined, undefined, $shown(text)));
}
function trends___term(match, text) {
let coefficient, factor, inner, power;
(coefficient = $b.Decimal($or($at(match, "number"), () => "1")));
if (($eq($at(match, "sign"), "-"))) {
(coefficient = $neg(coefficient));
}
(factor = $or($at(match, "factor"), () => ""));
if ($truth($m.startswith(factor, "ln"))) {
return new _Term(coefficient, "ln", $b.float($or($at(match, "log_power"), () => 1)), null);
}
if ($truth($m.startswith(factor, "exp"))) {
(inner = trends___sum(trends___terms($at(match, "exponent")), text, $b.Decimal(1)));
return new _Term(coefficient, "exp", 0.0, inner);
}
(power = ($truth(factor) ? $b.float($or($at(match, "within"), () => $or($at(match, "power"), () => "1"))) : 0.0));
return new _Term(coefficient, "p", power, null);
}
function trends___sum(terms, text, factor) {
let coefficients, count, form, functions, seen, term;

(functions = new Set((function* () { for (const term of $iter(terms)) { if (!($truth(term.power))) continue; yield term.function; } })()));
if ((($b.len(functions) > 1) || ($in("exp", new Set((function* () { for (const term of $iter(terms)) { yield term.function; } })()))))) {
throw trends___refused(text, "mixes kinds of trend lines");
}
(coefficients = $mul([0.0], 4));
(seen = $b.set());
for (term of $iter(terms)) {
if ((!$in(term.power, [0, 1, 2, 3]))) {
throw trends___refused(text, "a power of p that is not 1, 2 or 3 cannot be added to others");
}
if (($in(term.power, seen))) {
throw trends___refused(text, "has two terms of the same kind");
}
seen.add($bound(term, "power"));
$put(coefficients, $b.int($bound(term, "power")), trends___finite($mul(term.coefficient, factor), text));
}
(count = $add(1, $b.int($b.max(seen))));
(form = (($eq(functions, new Set(["ln"]))) ? "logarithmic" : "polynomial"));
return new Trend(form, $b.tuple($slice(coefficients, null, count)));
}
function trends___finite(number, text) {
let value;
(value = $b.float(number));
if (!$truth($math.isfinite(value))) {
throw trends___refused(text, "a number that is not finite");
}
return value;
}
function trends___scaled_exponent(exponent, coefficient, text) {
let c, first, form, sign, size;

(size = $b.abs(trends___finite(coefficient, text)));
if (($eq(size, 0.0))) {
throw trends___refused(text, "is 0 everywhere");
}
(c = exponent.coefficients);
(first = $add($at(c, 0), $math.log(size)));
(form = (($eq(exponent.form, "logarithmic")) ? "power" : "exponential"));
(sign = ((coefficient > 0) ? 1 : $neg(1)));
return new Trend(form, [first, ...$iter($slice(c, 1, null))], sign);
}
function trends___over_pascal(trend, unit) {
let c;

(c = trend.coefficients);
if ((!$eq(unit, 1.0))) {
if (($in(trend.form, ["logarithmic", "power"]))) {
(c = trends___shifted(c, $neg($math.log(unit))));
} else {
(c = $b.tuple((function* () { for (const [power, value] of $iter($b.enumerate(c))) { yield (value / $pow(unit, power)); } })()));
}
}
return new Trend(trend.form, c, trend.sign);
}
function trends___shifted(c, shift) {

return $b.tuple((function* () { for (const power of $iter($b.range($b.len(c)))) { yield $math.fsum((function* () { for (const k of $iter($b.range(power, $b.len(c)))) { yield $mul($mul($at(c, k), $math.comb(k, power)), $pow(shift, $sub(k, power))); } })()); } })());
}
function laws___knots(record) {
let key, rows, tail;
for (key of $iter(["slip_unit", "pressure_unit", "continuity"])) {
if (($in(key, record))) {
throw laws___problem(key, "belongs to pieces; each number of knots has its own unit");
}
}
(rows = $at(record, "knots"));
laws___check_order(rows, "knots");
laws___raise((function* () { for (const [number, row] of $iter($b.enumerate(rows, $k({start: 1})))) { if (!((($m.get(row, "post_peak_slope", 0.0) < 0.0) && (!$in("residual_friction", row))))) continue; yield laws___useless_slope(("" + "knots[" + $str(number) + "].residual_friction")); } })());
(tail = $b.any((function* () { for (const row of $iter(rows)) { yield $or(($in("post_peak_slope", row)), () => ($in("residual_friction", row))); } })()));
return new PressureKnots($b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_friction"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_slip"); } })()), ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "post_peak_slope", 0.0); } })()) : []), ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "residual_friction", $at(row, "peak_friction")); } })()) : []));
}
function lagging_build___factors(tested, law, record, report) {
let found, key, made, source, table, tables;

(tables = $map([]));
for ([key, table] of $iter([["slip_speed", $c72], ["temperature", $c73]])) {
if (($in(("" + $str(key) + "_factor"), law))) {
(source = origins__read_provenance($m.get($at(law, ("" + $str(key) + "_factor")), "provenance"), report));
(found = $method(table, "built", [$at(law, ("" + $str(key) + "_factor")), report], [["source", source]]));
if ((found == null)) {
return null;
}
$put(tables, ("" + "by_" + $str(key)), found);
}
if (($in(key, record))) {
$put(tables, key, $at(record, key));
}
}
if (!$truth(tables)) {
return null;
}
(made = report.tried((() => $call(Factors, [], [["law", tested], ...tables])), $bound(record, "place"), $bound(record, "raw")));
return made;
}
function lagging_build___check_conditions(laws, report) {
let condition, law, message, place, seen;
(seen = $b.set());
for (law of $iter(laws)) {
(condition = $m.get(law, "condition", "dry"));
if (($in(condition, seen))) {
(message = "a second law for this condition");
(place = [...$iter(law.place), "condition"]);
report.add(place, message, "Give each law its own condition.", condition);
}
seen.add(condition);
}
}
function lagging_file__is_path(text) {

return $or($m.endswith(text, ".toml"), () => $or(($in("/", text)), () => ($in("/", text))));
}
function lagging_file__catalogue_laggings(name) {

return $once(lagging_file___catalogue_laggings, $kept_lagging_file___catalogue_laggings)(name, laggingText(name));
}
function lagging_file___catalogue_laggings(name, text) {
return lagging_file___built($once(lagging_file___catalogue_record, $kept_lagging_file___catalogue_record)(name, text), ("" + "catalogue lagging " + $str(name)));
}
const $kept_lagging_file___catalogue_laggings = new Map();
function lagging_file___catalogue_record(name, text) {
let record;
(record = lagging_file___record(text, ("" + "catalogue lagging " + $str(name))));
if ((!$eq($at(record, "name"), name))) {
throw new InputError(new Problem("is not the name of its file", ("" + "Write name = " + $str($shown(name)) + ", or rename the file."), ("" + "catalogue lagging " + $str(name)), "name", $shown($at(record, "name"))));
}
return record;
}
const $kept_lagging_file___catalogue_record = new Map();
function lagging_file___record(text, file) {
return lagging_file___checked_record(parsed(text, file), file);
}
function lagging_file___checked_record(document, file) {
let record, report;

([record, report] = source__read_tables($c75, document, file));
if ($truth(report.problems)) {
lagging_build__build_laggings(record, report);
report.raise_all();
}
return record;
}
function lagging_file___built(record, file) {
let laggings, report;
(report = new Report(file));
(laggings = lagging_build__build_laggings(record, report));
report.raise_all();
return laggings;
}
function drive_build___at_home(error) {

return new InputError((function* () { for (const problem of $iter(error.problems)) { yield (($truth(problem.key) || $truth(problem.line) || !$truth(problem.file)) ? problem : new Problem(("" + $str(problem.file) + " " + $str(problem.message)), problem.remedy)); } })());
}
function lagging_file__lagging_record(name_or_path, folder, allow_paths) {
let path, text;

if (!$truth(lagging_file__is_path(name_or_path))) {
(text = laggingText(name_or_path));
return [$once(lagging_file___catalogue_record, $kept_lagging_file___catalogue_record)(name_or_path, text), ("" + "catalogue lagging " + $str(name_or_path))];
}
if (!$truth(allow_paths)) {
throw new InputError(new Problem("the path of a file cannot be used here", ("" + "Choose one of " + $str($m.join(", ", laggingNames())) + ", or put the lagging into the drive file as a [lagging.NAME] table."), undefined, undefined, $shown(name_or_path)));
}
(path = readText(folder, name_or_path));
return [lagging_file___record(readText(path), path), path];
}
function drive_build___merged_origins(base, given) {
let own, provenance, sources;

(own = $or($m.get(given, "provenance"), () => drive_build___given_instead(given)));
(sources = $map([...(function* () { for (const [key, of] of $iter($m.items($m.get(base, "sources", $map([]))))) { if (!((!$in(key, given)))) continue; yield [key, of]; } })()]));
(sources = $merged(sources, $map([...(function* () { for (const key of $iter(given)) { if (!(($in(key, $c77)))) continue; yield [key, own]; } })()])));
(provenance = (($in("provenance", base)) ? $map([["provenance", $at(base, "provenance")]]) : $map([])));
return $map([["sources", $merged(sources, $m.get(given, "sources", $map([])))], ...provenance]);
}
function drive_build___given_instead(given) {
let note;

(note = ("" + "instead of that of " + $str($at(given, "preset"))));
return new Record($map([["kind", "given"], ["note", note]]), $bound(given, "place"), $map([]));
}
function limits__limit_problems(thing, limits) {
let given, key, limit, message, problems, value;

(problems = []);
for ([key, limit] of $iter($m.items(limits))) {
(value = $b.getattr(thing, key));
(message = ((value == null) ? "" : limit.refusal(value)));
if ($truth(message)) {
(given = ($truth(isNumber(value)) ? display__display($b.float(value), $bound(limit, "dimension")) : $shown(value)));
$m.append(problems, new Problem(message, undefined, undefined, key, given));
}
}
return problems;
}
function conditions__design_ratio(standard, surface, condition, tested = "dry") {
let band, dry, here, high, known, low, note, source, there;

(there = [...(function* () { for (const d of $iter((() => $c51)())) { if (!((($eq(d.standard, standard)) && ($eq(d.surface, surface))))) continue; yield d; } })()]);
(here = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, condition)))) continue; yield d; } })(), null));
(dry = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, tested)))) continue; yield d; } })(), null));
if (((here == null) || (dry == null))) {
(known = $b.sorted(new Set((function* () { for (const d of $iter((() => $c51)())) { if (!($truth(d.condition))) continue; yield d.standard; } })())));
throw new InputError(new Problem(("" + "no design values of surface " + $str($shown(surface)) + " both " + $str(tested) + " and " + $str(condition)), ("" + $str($m.join(", ", known)) + " have dry, wet, and wet and dirty; or state a factor."), undefined, ("" + "condition." + $str(condition)), $shown(standard)));
}
([low, high] = [($at(here.friction, 0) / $at(dry.friction, 1)), ($at(here.friction, 1) / $at(dry.friction, 0))]);
(band = ((low < high) ? ("" + ", " + $format(low, ("" + ".3g")) + " to " + $format(high, ("" + ".3g"))) : ""));
(note = ("" + $str(surface) + " " + $str(condition) + " " + $str(conditions___ends(here)) + " over " + $str(tested) + " " + $str(conditions___ends(dry)) + ", middle values" + $str(band) + "; a ratio of constant design values applied to the whole law"));
(source = new Provenance("published", $bound(here.provenance, "source"), $bound(here.provenance, "date"), note));
return [($b.sum($bound(here, "friction")) / $b.sum($bound(dry, "friction"))), source];
}
function conditions___ends(design) {
let high, low;
([low, high] = design.friction);
return (($eq(low, high)) ? ("" + $format(low, ("" + "g"))) : ("" + $format(low, ("" + "g")) + "-" + $format(high, ("" + "g"))));
}
function conditions__published_conditions(surface) {
let values;

(values = (function* () { for (const d of $iter((() => $c51)())) { if (!((($eq(d.surface, surface)) && $truth(d.condition)))) continue; yield d; } })());
return $b.tuple($b.fromkeys((function* () { for (const d of $iter(values)) { yield d.condition; } })()));
}
function criteria__choice_problems(thing, choices) {

return [...(function* () { for (const [key, words] of $iter($m.items(choices))) { if (!((!$in($b.getattr(thing, key), words)))) continue; yield new Problem(("" + "must be one of " + $str($m.join(", ", (function* () { for (const word of $iter(words)) { if (!($truth(word))) continue; yield word; } })()))), undefined, undefined, key, $shown($b.getattr(thing, key))); } })()];
}
function limits__name_problems(key, name) {
let message;

if (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($b.len(name) <= 60) && $truth($m.isprintable(name)))) {
return [];
}
(message = "must be a printable text of 1 to 60 characters");
return [new Problem(message, undefined, undefined, key, $shown(name))];
}
function drive___wrong_pulleys(case_, names) {
let missing, parts, unknown;
([missing, unknown] = [$b.sorted($sub(names, $m.keys(case_.tensions))), $b.sorted($sub($m.keys(case_.tensions), names))]);
(parts = ($truth(missing) ? [("" + "no tensions for " + $str($shown(missing)))] : []));
(parts = $add(parts, ($truth(unknown) ? [("" + "tensions for " + $str($shown(unknown)) + ", which the drive does not have")] : [])));
return new Problem($m.join(" and ", parts), undefined, undefined, ("" + "load_case." + $str(case_.name)));
}
function drive__condition_problems(case_, condition, pulleys) {

return [...(function* () { for (const p of $iter(pulleys)) { if (!(($truth(condition) && (!$in(condition, (function* () { for (const lagging of $iter(p.conditions)) { yield lagging.condition; } })()))))) continue; yield new Problem(("" + "pulley " + $str($shown($bound(p, "name"))) + " does not say its lagging in this condition"), undefined, undefined, ("" + "load_case." + $str(case_) + ".condition"), $shown(condition)); } })()];
}
function drive__named(what, name, among, of = "the drive") {
let one;

for (one of $iter(among)) {
if (($in(name, [null, one.name]))) {
return one;
}
}
throw errors__no_such(what, name, [...(function* () { for (const one of $iter(among)) { yield one.name; } })()], of);
}
function errors__no_such(what, name, known, of = "the drive") {
let names, there;

(names = $b.list(known));
(there = ("" + "It has " + $str($m.join(", ", $b.map($shown, names))) + "."));
return new InputError(new Problem(("" + $str(of) + " has no such " + $str(what)), $m.strip(("" + $str(errors__nearest(name, names)) + " " + $str(there))), undefined, undefined, $shown(name)));
}
function load_case__heaviest(cases, pull) {
let running;

(running = [...(function* () { for (const case_ of $iter(cases)) { if (!(($eq(case_.kind, "running")))) continue; yield case_; } })()]);
return alike__largest($or(running, () => cases), ((case_) => $b.abs(pull(case_))));
}
function drive__laggings_of(pulleys, conditions) {
let condition, found, lagging, pulley;

(found = $map([]));
for (condition of $iter(conditions)) {
for (pulley of $iter(pulleys)) {
(lagging = pulley.lagging_in(condition));
$m.setdefault(found, [lagging.name, lagging.condition], lagging);
}
}
return $b.tuple($m.values(found));
}
function train___count_problems(key, values, count) {
let message;
if (($eq($b.len(values), count))) {
return [];
}
(message = ("" + "must have one value for each of the " + $str(count) + " pulleys"));
return [new Problem(message, undefined, undefined, key, ("" + $str($b.len(values)) + " values"))];
}
function train___case_problems(case_, names) {
let count, division, given, message, problems, speeds, where;

([where, count] = [("" + "load_case." + $str(case_.name)), $b.len(names)]);
(problems = []);
if (($truth(case_.runs) && (!$eq($b.len($bound(case_, "runs")), $sub(count, 1))))) {
(message = ("" + "must have one value for each of the " + $str($sub(count, 1)) + " runs between pulleys"));
(given = ("" + $str($b.len($bound(case_, "runs"))) + " values"));
$m.append(problems, new Problem(message, undefined, undefined, ("" + $str(where) + ".run"), given));
} else {
if (!$truth($b.all($b.map($math.isfinite, $bound(case_, "runs"))))) {
$m.append(problems, new Problem("must be finite", undefined, undefined, ("" + $str(where) + ".run")));
}
}
if ($truth(problems)) {
return problems;
}
(division = case_.division);
if ($truth($b.isinstance(division, Shares))) {
return train___share_problems(("" + $str(where) + ".share"), $bound(division, "fractions"), case_, count);
}
if ($truth($b.isinstance(division, Pulls))) {
return train___pull_problems(("" + $str(where) + ".share"), $bound(division, "effective_tensions"), case_, count);
}
if ($truth($b.isinstance(division, Speeds))) {
(speeds = division.rotation_speeds);
(problems = train___count_problems(("" + $str(where) + ".speeds"), speeds, count));
if (!$truth($b.all((function* () { for (const speed of $iter(speeds)) { yield (0.0 < speed && speed < Infinity); } })()))) {
(message = "every speed must be positive and finite");
$m.append(problems, new Problem(message, undefined, undefined, ("" + $str(where) + ".speeds")));
}
return problems;
}
return train___motor_problems(("" + $str(where) + ".motor"), $bound(division, "motors"), names);
}
function train___share_problems(key, fractions, case_, count) {
let given, message, problems, pulls, remedy, total;
(problems = train___count_problems(key, fractions, count));
(total = $math.fsum(fractions));
if ((!$truth(problems) && !($b.abs($sub(total, 1.0)) <= 1e-06))) {
(given = $m.join(", ", (function* () { for (const f of $iter(fractions)) { yield ("" + $format(f, ("" + "g"))); } })()));
(message = ("" + "the shares must sum to 1 and sum to " + $format(total, ("" + ".6g"))));
(remedy = "Give fractions like 0.5 or 50 %.");
$m.append(problems, new Problem(message, remedy, undefined, key, ("" + "[" + $str(given) + "]")));
}
(pulls = [...(function* () { for (const f of $iter(fractions)) { yield $mul(f, case_.effective_tension); } })()]);
return $or(problems, () => train___slack_problems(key, pulls, case_));
}
function train___slack_problems(key, pulls, case_) {
let low, message, remedy;
(low = $b.min((function* () { for (const pair of $iter(train__tensions_at(case_, pulls))) { yield $b.min(pair); } })()));
if ((low > 0.0)) {
return [];
}
(message = ("" + "leaves a tension of " + $str(display__display(low, "force")) + " in the belt, and a belt cannot push"));
(remedy = "Give other shares, or more tension on the slack side.");
return [new Problem(message, remedy, undefined, key)];
}
function train__tensions_at(case_, pulls) {
let runs;

(runs = [...(function* () { for (const i of $iter($b.range($b.len(pulls)))) { yield case_.run(i); } })()]);
return train__along($bound(case_, "entry_tension"), $bound(case_, "exit_tension"), runs, pulls);
}
function train__along(entry, exit_, runs, pulls) {
let i, now, out, pairs, pull, run;

(pairs = []);
(now = entry);
for ([i, [pull, run]] of $iter($b.enumerate($b.zip(pulls, runs, $k({strict: true}))))) {
(out = (($eq(i, $sub($b.len(pulls), 1))) ? exit_ : $sub(now, pull)));
$m.append(pairs, new Pair(now, out));
(now = $add(out, run));
}
return pairs;
}
function train___pull_problems(key, pulls, case_, count) {
let asked, message, problems, size, total;
(problems = train___count_problems(key, pulls, count));
([total, asked] = [$math.fsum(pulls), case_.effective_tension]);
(size = $b.max($bound(case_, "entry_tension"), $bound(case_, "exit_tension")));
if ((!$truth(problems) && !($b.abs($sub(total, asked)) <= $mul(1e-06, size)))) {
(message = ("" + "the pulleys together pull " + $str(display__display(total, "force", undefined, 6)) + ", and the tensions at both ends ask for " + $str(display__display(asked, "force", undefined, 6))));
$m.append(problems, new Problem(message, undefined, undefined, key));
}
return $or(problems, () => train___slack_problems(key, pulls, case_));
}
function train___motor_problems(key, motors, names) {
let by_name, leads, message, motor, name, problems, where;
(problems = train___count_problems(key, motors, $b.len(names)));
if ($truth(problems)) {
return problems;
}
(by_name = $b.dict($b.zip(names, motors, $k({strict: true}))));
for ([name, motor] of $iter($m.items(by_name))) {
if (!$truth($b.isinstance(motor, TorqueFollower))) {
continue;
}
(leads = $m.get(by_name, $bound(motor, "master")));
(where = ("" + $str(key) + "." + $str(name) + ".master"));
if ((leads == null)) {
(message = ("" + "no such pulley; the pulleys are " + $str($m.join(", ", $b.map($shown, names)))));
$m.append(problems, new Problem(message, undefined, undefined, where, $shown($bound(motor, "master"))));
} else {
if ($truth($b.isinstance(leads, TorqueFollower))) {
(message = "the drive that is followed must not follow another one itself");
$m.append(problems, new Problem(message, undefined, undefined, where, $shown($bound(motor, "master"))));
}
}
}
if (($eq($at($b.Counter($b.map($b.type, motors)), TorqueFollower), $b.len(motors)))) {
(message = "every drive follows another one: one must hold the speed");
$m.append(problems, new Problem(message, undefined, undefined, key));
}
return problems;
}
function train___case_of(drive, case_) {
let pairs, runs;
(pairs = [...(function* () { for (const p of $iter(drive.pulleys)) { yield $at(case_.tensions, p.name); } })()]);
(runs = $b.tuple((function* () { for (const [a, b] of $iter($b.pairwise(pairs))) { yield $sub(b.entry, a.exit); } })()));
return new TrainCase(case_.name, $at(pairs, 0).entry, $at(pairs, $neg(1)).exit, new Pulls($b.tuple((function* () { for (const pair of $iter(pairs)) { yield pair.effective; } })())), ($truth($b.any(runs)) ? runs : []), case_.kind, case_.condition);
}
function wrap_arc__of_belt(belt, side, law) {
let counted, cover;

([counted, cover] = [pitch__counts_shear(law, "cover shear"), pitch__cover_compliance(belt, side)]);
return $map([["pitch_offset", pitch__pitch_offset(belt, side)], ["cover_compliance", ((counted === false) ? cover : 0.0)], ["cover_left_out", ((counted == null) ? cover : 0.0)], ["side_of_belt", side], ["belt_thickness", pitch__whole_thickness(belt)], ["centrifugal", pitch__centrifugal_of(belt)]]);
}
function pitch__counts_shear(law, part) {

return ((law.slip_includes == null) ? null : ($in(part, law.slip_includes)));
}
function pitch__cover_compliance(belt, side) {
let cover, modulus;

(cover = pitch__touching_cover(pitch__layers_of(belt), ($eq(side, "carry"))));
(modulus = ((belt.cover_shear_modulus == null) ? 1000000.0 : belt.cover_shear_modulus));
return ($truth($math.isnan(cover)) ? 0.0 : (cover / modulus));
}
function pitch__whole_thickness(belt) {
let total;

(total = ((belt.thickness == null) ? $b.sum(pitch__layers_of(belt)) : belt.thickness));
return ($truth($math.isnan(total)) ? null : total);
}
function numbers__margin_of(value, limit, at_most) {

if (($truth($math.isnan(value)) || $truth($math.isnan(limit)) || ($eq(limit, 0.0)))) {
return NaN;
}
if (!$truth($math.isfinite(value))) {
return ($truth(at_most) ? NaN : Infinity);
}
return $add($mul(($truth(at_most) ? 1.0 : $neg(1.0)), $sub(1.0, (value / limit))), 0.0);
}
function numbers__times_of(value, limit) {

if (($truth($math.isnan(value)) || $truth($math.isnan(limit)) || (limit <= 0.0) || !$truth($math.isfinite(value)))) {
return NaN;
}
return (((value / limit) >= 10.0) ? (value / limit) : NaN);
}
function check__quantity_text(value, dimension, against = NaN) {
let form;

if ($truth($math.isnan(value))) {
return "";
}
if ($truth($math.isinf(value))) {
return cell__quantity(value, dimension);
}
(form = ($truth($math.isnan(against)) ? "slip" : "slip apart"));
return cellOf(value, dimension, undefined, form, against);
}
function numbers__beyond(value, fails, at_most) {

return ($truth(at_most) ? (value > fails) : (value < fails));
}
function check___badness(check) {
let order, unknown;

(order = numbers__order_of($bound(check, "margin"), $bound(check, "missed"), $bound(check, "binding"), $bound(check, "advises"), $bound(check, "leads")));
(unknown = (check.level === "NOT CHECKED"));
return [$neg(($truth(unknown) ? $add($told($c85, "OK", "rank"), 0.5) : $told($c85, check.level, "rank"))), order];
}
function numbers__order_of(margin, missed, binding, advises, leads) {
let found;

(found = (($b.abs(margin) < 1000000000.0) ? $mul($math.floor($add((margin / 1e-09), 0.5)), 1e-09) : margin));
if ($truth($math.isnan(margin))) {
(found = (($truth(missed) && $truth(binding)) ? -2000000000.0 : Infinity));
}
if ($truth(leads)) {
return $sub($b.min(found, 1000000000.0), 4000000000.0);
}
return (($truth(missed) && $truth(advises)) ? $add($b.max(found, $neg(1000000000.0)), $mul(2.0, 1000000000.0)) : found);
}
function check__placed(check) {
let said, where;

([where, said] = [check___capital($b.str($bound(check, "place"))), check.said]);
return ((!$truth(where) || $truth($m.startswith(said, where))) ? said : ("" + $str(where) + ": " + $str(said)));
}
function check___capital(text) {
return $add($m.upper($slice(text, null, 1)), $slice(text, 1, null));
}
function check___small(text) {
return $add($m.lower($slice(text, null, 1)), $slice(text, 1, null));
}
function base__check(...tests) {
let failed;

(failed = [...(function* () { for (const [passed, key, value, message] of $iter(tests)) { if (!(!$truth(passed))) continue; yield new Problem(message, undefined, undefined, key, value); } })()]);
if ($truth(failed)) {
throw new InputError(failed);
}
}
function table___ascending(values) {
return $b.all((function* () { for (const [a, b] of $iter($b.pairwise(values))) { yield (a < b); } })());
}
function trend___exp(power) {

return ((power < 709.0) ? $math.exp(power) : Infinity);
}
function coefficients___list(values, unit = "") {
return $add($m.join(", ", (function* () { for (const v of $iter(values)) { yield ("" + $format(v, ("" + "g"))); } })()), ($truth(unit) ? ("" + " " + $str(unit)) : ""));
}
function coefficients__peak_from_ab(a, b) {
let slip;

(slip = $math.exp($sub((b / a), 1.0)));
return [$mul($neg(a), slip), slip];
}
function factors___outside(key, value, table, dimension) {
let ends, high, low, message, remedy;

if ((value == null)) {
return [];
}
if ((table == null)) {
(message = ("" + "given, and the law has no " + $str(key) + "_factor"));
(remedy = ("" + "Leave it out, or add [law." + $str(key) + "_factor] with its source."));
return [new Problem(message, remedy, undefined, key, display__display(value, dimension))];
}
([low, high] = [(($eq(key, "slip_speed")) ? 0.0 : $at(table.at, 0)), $at(table.at, $neg(1))]);
if ((low <= value && value <= high)) {
return [];
}
(ends = ("" + $str(display__display($at(table.at, 0), dimension)) + " to " + $str(display__display(high, dimension))));
(message = ("" + "outside the " + $str(ends) + " that its factor is known for"));
return [new Problem(message, "Test the lagging there, and add the factor to its table.", undefined, key, display__display(value, dimension))];
}
function tables___kind_of(owner, attribute) {
let kind, rigid, types;

if ((owner == null)) {
throw new $TypeError(("" + $str(attribute) + " has neither a kind nor a class that says it"));
}
if (($in(attribute, $b.getattr(owner, "LIMITS", $map([]))))) {
(kind = tables__limited(owner, attribute));
(rigid = $and((kind.limit != null), () => kind.limit.rigid));
return ($truth(rigid) ? new WordOr("rigid", kind, Infinity) : kind);
}
(types = $map([...(function* () { for (const f of $iter($fields(owner))) { yield [f.name, f.type]; } })()]));
if (($in($at(types, attribute), [$b.bool, "bool"]))) {
return new Flag();
}
throw new $TypeError(("" + $str(owner.__name__) + " does not say what " + $str(attribute) + " may be"));
}
function tables__limited(owner, key) {
let limit;

(limit = $at(owner.LIMITS, key));
return new Quantity($bound(limit, "dimension"), limit);
}
function tables__missing_remedy(entry) {
let kind;

(kind = entry.kind);
if ($truth(entry.example)) {
return ("" + "Write " + $str(entry.example) + ".");
}
if ($truth($b.isinstance(kind, Quantity))) {
return ("" + "Write for example " + $str(entry.key) + " = " + $str($shown($bound($at($c12, kind.dimension), "example"))) + ".");
}
if ($truth($b.isinstance(kind, Choice))) {
return ("" + "Write " + $str(entry.key) + " = " + $str($shown($at(kind.options, 0))) + " or another of its words.");
}
return ("" + "Add " + $str(entry.key) + ".");
}
function tables___sound(value) {

if ($truth($b.isinstance(value, Record))) {
return value.sound();
}
if ($truth($b.isinstance(value, "dict"))) {
return $b.all($b.map(tables___sound, $m.values(value)));
}
if ($truth($b.isinstance(value, "list"))) {
return $b.all($b.map(tables___sound, value));
}
return (value !== $c7);
}
function tables___frozen(value) {
return ($truth($b.isinstance(value, "list")) ? $b.tuple($b.map(tables___frozen, value)) : value);
}
function tables__need(key, meaning = "", kind = $c724, more = new Map()) {

return $replaced($call(Entry, [key, meaning, kind], [...more]), new Map([["required", true]]));
}
function resistance__no_coefficient(length) {
let least;

if (!$truth($math.isnan(resistance__coefficient_at(length)))) {
return [];
}
(least = $at($at($c729, 0), 0));
return [new Problem(("" + "is below " + $format(least, ("" + "g")) + " m, where no coefficient C is tabulated"), "Give secondary_resistance, or a length_coefficient of your own.", undefined, "length", display__display(length, "length"))];
}
function resistance__coefficient_at(length) {
let end, found, high, low, start;

(found = ((length < $at($at($c729, 0), 0)) ? NaN : $at($at($c729, $neg(1)), 1)));
for ([[start, high], [end, low]] of $iter($b.pairwise($c729))) {
if ((start <= length && length <= end)) {
return $add(high, ($mul($sub(low, high), $sub(length, start)) / $sub(end, start)));
}
}
return found;
}
function conveyor___known(value, other) {
return ((value == null) ? other : value);
}
function conveyor___slack(state, least) {
let message, remedy, where;

(where = (($in(least, [state.entry, state.exit])) ? "beside the drive pulley" : "at the far end"));
(message = ("" + "leaves a belt tension of " + $str(display__display(least, "force")) + " " + $str(where) + " in load case " + $str(state.name) + ", and a belt cannot push"));
(remedy = "Give a larger take-up tension.");
return new Problem(message, remedy, undefined, "take_up_tension");
}
function resistance__main_resistance(friction_factor, length, lift, rotating, carried) {
let cosine;

(cosine = $math.sqrt($sub(1.0, $pow((lift / length), 2))));
return $mul($mul($mul(friction_factor, length), 9.80665), $add(rotating, $mul(carried, cosine)));
}
function resistance__slope_resistance(lift, carried) {

return $mul($mul(9.80665, lift), carried);
}
function resistance__inertia(acceleration, length, moving) {

return $mul($mul(acceleration, length), moving);
}
function fit___has_no_negative(covariance, rounding) {
let before, given, i, j, lower, rest, row, scale;

(scale = [...(function* () { for (const [i, row] of $iter($b.enumerate(covariance))) { yield $or($math.sqrt($b.abs($at(row, i))), () => 1.0); } })()]);
(lower = []);
for ([i, given] of $iter($b.enumerate(covariance))) {
(row = []);
for (j of $iter($b.range($add(i, 1)))) {
(before = ((j < i) ? $at(lower, j) : row));
(rest = $add(($at(given, j) / $mul($at(scale, i), $at(scale, j))), (($eq(i, j)) ? rounding : 0.0)));
(rest = $sub(rest, $math.fsum((function* () { for (const [a, b] of $iter($b.zip(row, $slice(before, null, j), $k({strict: true})))) { yield $mul(a, b); } })())));
if ((($eq(i, j)) && (rest <= 0.0))) {
return false;
}
$m.append(row, (($eq(i, j)) ? $math.sqrt(rest) : (rest / $at($at(lower, j), j))));
}
$m.append(lower, row);
}
return true;
}
function motors___rpm(speed) {
return ("" + $format(($mul(speed, 30.0) / 3.141592653589793), ("" + ".6g")) + " rpm");
}
function kinds__table_labels(rows) {
let names;

(names = [...(function* () { for (const row of $iter(rows)) { yield ($truth($b.isinstance(row, "dict")) ? $m.get(row, "name") : null); } })()]);
return [...(function* () { for (const [position, name] of $iter($b.enumerate(names, $k({start: 1})))) { yield (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($eq($m.count(names, name), 1))) ? name : position); } })()];
}
function simple___edges(tested) {
return ((tested == null) ? [] : [tested.pressure_min, tested.pressure_max]);
}
function quantity_text__quantity_text(value, dimension) {
let digits, exact, factor, number, plain, text, unit;

([unit, factor] = display__display_unit(dimension));
(number = (value / factor));
(exact = ($b.Decimal($b.repr(value)) / $b.Decimal($b.repr(factor))));
for (digits of $iter([("" + $format(number, ("" + ".15g"))), ("" + $format(number, ("" + ".16g"))), ("" + $format(number, ("" + ".17g"))), $b.str(exact)])) {
(plain = ("" + $format($b.Decimal(digits), ("" + "f"))));
(text = ("" + $str((($b.len(plain) < 20) ? plain : digits)) + " " + $str(unit)));
if (($eq(parse__parse_quantity(text, dimension), value))) {
return text;
}
}
return ("" + $repr(value) + " " + $str($at($c12, dimension).si_unit));
}
function display__display_unit(dimension, system = "si") {
let row;

(row = $once(display__unit_row, $kept_display__unit_row)(dimension, system));
return [row.unit, row.factor];
}
class Problem extends $Object {
$init(message, remedy = "", file = "", key = "", value = "", line = null) { this.message = message; this.remedy = remedy; this.file = file; this.key = key; this.value = value; this.line = line;  }
__str__() {
const self = this; let given, place, sentence;
(place = self.file);
if ((self.line != null)) {
(place = ($truth(place) ? ("" + $str(place) + ", line " + $str(self.line)) : ("" + "line " + $str(self.line))));
}
(given = $m.join(" = ", (function* () { for (const part of $iter([self.key, self.value])) { if (!($truth(part))) continue; yield part; } })()));
(sentence = $m.join(": ", (function* () { for (const part of $iter([place, given, self.message])) { if (!($truth(part))) continue; yield part; } })()));
return $m.join(" ", (function* () { for (const part of $iter([errors___stopped(sentence), errors___stopped($bound(self, "remedy"))])) { if (!($truth(part))) continue; yield part; } })());
}
}
class WraparcError extends $Error {
}
class InputError extends WraparcError {
$init(problems) {
const self = this; (self.problems = ($truth($b.isinstance(problems, Problem)) ? [problems] : $b.tuple(problems)));
if (!$truth(self.problems)) {
throw new $TypeError("InputError needs at least one Problem");
}
super.$init($bound(self, "problems"));
}
__str__() {
const self = this; let lines;
if (($eq($b.len($bound(self, "problems")), 1))) {
return $b.str($at(self.problems, 0));
}
(lines = $m.join("\n", (function* () { for (const problem of $iter(self.problems)) { yield ("" + "  - " + $str(problem)); } })()));
return ("" + $str($b.len($bound(self, "problems"))) + " problems:\n" + $str(lines));
}
}
class Report extends $Object {
$init(file = "") {
const self = this; (self.file = file);
(self.problems = []);
(self._left_out = 0);
}
add(place, message, remedy = "", value = $c7) {
const self = this; let given;

if ($truth(self.full)) {
(self._left_out = $add(self._left_out, 1));
return null;
}
(given = ((value === $c7) ? "" : $shown(value)));
self._append(new Problem(message, remedy, undefined, problems__place_text(place), given));
}
take(error, place, raw = $c7, names = null) {
const self = this; let below, given, key, problem, value;

for (problem of $iter(error.problems)) {
if ($truth(problem.file)) {
self._append(problem);
continue;
}
(below = problems___renamed($bound(problem, "key"), $or(names, () => $map([]))));
(given = problems__value_at(raw, below));
(value = ((given === $c7) ? problem.value : $shown(given)));
if ($truth($b.isinstance(given, "list", "dict"))) {
(value = problem.value);
}
(key = problems__place_text($add(place, below)));
self._append($replaced(problem, new Map([["key", key], ["value", value], ["file", self.file]])));
}
}
tried(make, place, raw = $c7, names = null) {
const self = this; let error;

try {
return make();
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self.take(error, place, raw, names);
return null;
} else throw $error;
}
}
sure(make, place = []) {
const self = this; let made;

(made = self.tried(make, place));
self.raise_all();

return made;
}
_append(problem) {
const self = this; (problem = ($truth(problem.file) ? problem : $replaced(problem, new Map([["file", self.file]]))));
if (($in(problem, self.problems))) {
return null;
}
if (($b.len($bound(self, "problems")) < 50)) {
$m.append(self.problems, problem);
} else {
(self._left_out = $add(self._left_out, 1));
}
}
raise_all() {
const self = this; let message;

if ($truth(self._left_out)) {
(message = ("" + $str(self._left_out) + " more problems are not listed"));
$m.append(self.problems, new Problem(message, undefined, self.file));
}
if ($truth(self.problems)) {
throw new InputError($bound(self, "problems"));
}
}
get full() {
const self = this; 
return ($b.len($bound(self, "problems")) >= 50);
}
}
class Record extends $Dict {
$init(values, place, raw, faulty = []) {
const self = this; super.$init(values);
(self.place = place);
(self.raw = raw);
(self.faulty = $b.set(faulty));
}
sound(...keys) {
const self = this; 
return ($truth(keys) ? $m.isdisjoint(self.faulty, keys) : !$truth(self.faulty));
}
}
class Provenance extends $Object {
$init(kind = "given", source = "", date = "", note = "") { this.kind = kind; this.source = source; this.date = date; this.note = note; this.__post_init__?.(); }
__post_init__() {
const self = this; if (((self.kind === "published") && !$truth($m.strip(self.source)))) {
throw new InputError(new Problem("a published number without a source", "Name the publication, or call the number given or illustrative."));
}
}
__str__() {
const self = this; let origin, stated;
(origin = $m.join(", ", (function* () { for (const part of $iter([self.source, self.date])) { if (!($truth(part))) continue; yield part; } })()));
(stated = ($truth(origin) ? ("" + $str(self.kind) + ": " + $str(origin)) : $b.str($bound(self, "kind"))));
return ($truth(self.note) ? ("" + $str(stated) + " (" + $str(self.note) + ")") : stated);
}
}
class Laggings extends $Object {
$init(own, folder, allow_paths, report) {
const self = this; (self._report = report);
(self._folder = folder);
(self._allow_paths = allow_paths);
(self._names = $b.tuple(own));
(self._own = $map([]));
(self._built = $map([]));
(self._own = $map([...(function* () { for (const [name, record] of $iter($m.items(own))) { yield [name, ($truth($b.isinstance(record, Record)) ? self._merged(record, name) : null)]; } })()]));
(self._built = $map([...(function* () { for (const [name, record] of $iter($m.items(self._own))) { yield [name, ($truth(record) ? lagging_build__build_laggings(record, report) : [])]; } })()]));
}
of(value, place) {
const self = this; let kept, merged, name, record;

if ($truth($b.isinstance(value, Record))) {
(merged = self._merged(value, ""));
return ($truth(merged) ? lagging_build__build_laggings(merged, $bound(self, "_report")) : []);
}
if (($in(value, self._built))) {
return $at(self._built, $b.str(value));
}
(name = $b.str(value));
(record = self._found(name, place));
if ((record == null)) {
return [];
}
if ($truth(lagging_file__is_path(name))) {
return lagging_build__build_laggings(record, $bound(self, "_report"));
}
(kept = self._report.tried((() => lagging_file__catalogue_laggings(name)), place, name));
return $or(kept, () => []);
}
_found(name, place) {
const self = this; let error, known;

if (($in(name, self._own))) {
return ($truth($at(self._built, name)) ? $at(self._own, name) : null);
}
try {
(known = [...$iter(self._names), ...$iter(laggingNames())]);
if ((!$truth(lagging_file__is_path(name)) && (!$in(name, known)))) {
throw loader__unknown_name("lagging", name, known, "wraparc laggings");
}
return $at(lagging_file__lagging_record(name, $bound(self, "_folder"), $bound(self, "_allow_paths")), 0);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self._report.take(drive_build___at_home(error), place, name);
return null;
} else throw $error;
}
}
_merged(given, name) {
const self = this; let base, group, key, owner, values;

(base = null);
if (($in("preset", given))) {
(base = self._found($at(given, "preset"), [...$iter(given.place), "preset"]));
if ((base == null)) {
return null;
}
}
(values = $b.dict($or(base, () => $map([]))));
for (group of $iter($c76)) {
if ($truth($b.any((function* () { for (const key of $iter(group)) { yield ($in(key, given)); } })()))) {
for (key of $iter(group)) {
$m.pop(values, key, null);
}
}
}
(owner = (($b.len($bound(given, "place")) > 1) ? $b.str($at(given.place, $neg(2))) : "lagging"));
(values = $map([["name", $or(name, () => owner)], ...values, ...given]));
if ((base != null)) {
(values = $merged(values, drive_build___merged_origins(base, given)));
}
return new Record(values, $bound(given, "place"), $bound(given, "raw"), $bound(given, "faulty"));
}
}
class Condition extends $Object {
$init(name, factor = null, factors = new Map(), standard = "", source = new Provenance()) { this.name = name; this.factor = factor; this.factors = factors; this.standard = standard; this.source = source; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), self._wetter()));
}
_wetter() {
const self = this; let factors, message, remedy;

(factors = $map([["factor", self.factor], ...self.factors]));
if ((!$in("wet", $m.split($m.lower(self.name))))) {
return [];
}
([message, remedy] = ["more friction wet than dry", "Give friction when wet over dry, 0.8 say."]);
return [...(function* () { for (const [key, factor] of $iter($m.items(factors))) { if (!(((factor != null) && (factor > 1.0)))) continue; yield new Problem(message, remedy, undefined, key, ("" + $format(factor, ("" + "g")))); } })()];
}
lagging(lagging) {
const self = this; let factor, source;

if (($eq(lagging.condition, self.name))) {
return lagging;
}
([factor, source] = self.factor_of(lagging));
return $replaced(lagging, new Map([["law", lagging.law.scaled(factor)], ["condition", self.name], ["sources", $map([...lagging.sources, ["condition", source]])], ["fit", null], ["factors", null], ["notes", [...$iter(lagging.notes), self._told(lagging, factor, source)]]]));
}
_told(lagging, factor, source) {
const self = this; let by;

(by = ((source.kind === "published") ? ("" + ", " + $str($at($m.partition(source.source, " and "), 0))) : ""));
return ("" + $str(self.name) + ": friction " + $format(factor, ("" + ".3g")) + " of " + $str(lagging.condition) + $str(by));
}
of(laws) {
const self = this; let tested;

(tested = $b.next((function* () { for (const lagging of $iter(laws)) { if (!(($eq(lagging.condition, self.name)))) continue; yield lagging; } })(), null));
if ((tested != null)) {
return tested;
}
return self.lagging($b.next((function* () { for (const lag of $iter(laws)) { if (!(($eq(lag.condition, "dry")))) continue; yield lag; } })(), $at(laws, 0)));
}
factor_of(lagging) {
const self = this; let own;

(own = $m.get(lagging.condition_factors, $bound(self, "name")));
if ((own != null)) {
return [own.factor, own.source];
}
if (($in(lagging.surface, self.factors))) {
return [$at(self.factors, lagging.surface), self.source];
}
if ($truth(self.standard)) {
return conditions__design_ratio($bound(self, "standard"), $bound(lagging, "surface"), $bound(self, "name"), $bound(lagging, "condition"));
}
if ((self.factor != null)) {
return [self.factor, self.source];
}
if (($eq(self.name, "dry") && $eq("dry", lagging.condition))) {
return [1.0, new Provenance()];
}
return self._published(lagging);
}
_published(lagging) {
const self = this; let standard, tables;

(tables = $b.fromkeys((function* () { for (const d of $iter((() => $c51)())) { if (!($truth(d.condition))) continue; yield d.standard; } })()));
for (standard of $iter($b.sorted(tables, $k({key: ((name) => (!$eq(name, "DIN 22101")))})))) {
try {
return conditions__design_ratio(standard, $bound(lagging, "surface"), $bound(self, "name"), $bound(lagging, "condition"));
} catch ($error) {
if ($error instanceof InputError) {
continue;
} else throw $error;
}
}
throw new InputError(self._uncovered(lagging));
}
_uncovered(lagging) {
const self = this; let covered, known, name;
(known = conditions__published_conditions($bound(lagging, "surface")));
(covered = ($truth(known) ? ("" + "of " + $str(lagging.surface) + " " + $str($m.join(", ", known))) : "of its surface none"));
if (!$truth(lagging.surface)) {
(covered = "its surface is not said, so that no published value applies");
}
(name = $shown($bound(self, "name")));
return new Problem(("" + "lagging " + $str($shown($bound(lagging, "name"))) + " was tested " + $str(lagging.condition) + ", and nothing is published on its friction when " + $str(self.name) + " (covered: " + $str(covered) + ")"), $m.join(" ", (function* () { for (const part of $iter([errors__nearest($bound(self, "name"), known), ("" + "Give what it leaves of the friction, condition = { name = " + $str(name) + ", friction_factor = 0.8 }, or add a law for it to the lagging.")])) { if (!($truth(part))) continue; yield part; } })()), undefined, ("" + "condition." + $str(self.name)));
}
}
class Conditions extends $Object {
$init(main = [], cases = []) { this.main = main; this.cases = cases;  }
get several() {
const self = this; 
return [...$iter((($b.len($bound(self, "main")) > 1) ? self.main : [])), ...$iter(self.cases)];
}
}
class Point extends $Object {
$init(x, y, diameter = 0.0, turn = "clockwise") { this.x = x; this.y = y; this.diameter = diameter; this.turn = turn; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get side() {
const self = this; 
return $mul((self.diameter / 2.0), (($eq(self.turn, "counterclockwise")) ? 1.0 : $neg(1.0)));
}
}
class _UnitTextError extends $Error {
$init(message, remedy) {
const self = this; super.$init(message);
(self.remedy = remedy);
}
}
class Unit extends $Object {
$init(factor, powers, zero = $c86) { this.factor = factor; this.powers = powers; this.zero = zero;  }
*[Symbol.iterator]() { yield this.factor; yield this.powers; yield this.zero; }
}
class UnitRow extends $Object {
$init(unit, factor, larger) { this.unit = unit; this.factor = factor; this.larger = larger;  }
*[Symbol.iterator]() { yield this.unit; yield this.factor; yield this.larger; }
}
class WidthProfile extends $Object {
$init(position = [], value = [], crown = 0.0, uncertainty = null) { this.position = position; this.value = value; this.crown = crown; this.uncertainty = uncertainty; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, numbers, problems, wrong;
(problems = []);
(numbers = [...$iter(self.position), ...$iter(self.value), self.crown]);
if ((!$truth($b.all($b.map($math.isfinite, numbers))) || (!$eq($b.len($bound(self, "position")), $b.len($bound(self, "value")))))) {
(message = "must be pairs of finite numbers, position and value");
$m.append(problems, new Problem(message, undefined, undefined, "rows", $b.str($b.len($bound(self, "position")))));
} else {
if (($eq($b.len($bound(self, "position")), 1))) {
(message = "one row alone makes no profile");
$m.append(problems, new Problem(message, "Give two rows or more.", undefined, "rows"));
}
}
(wrong = [...(function* () { for (const [a, b] of $iter($b.pairwise($bound(self, "position")))) { if (!((b <= a))) continue; yield b; } })()]);
if ($truth(wrong)) {
$m.append(problems, new Problem("the positions must ascend from one edge of the belt to the other", "Sort the rows by position, the middle of the belt being 0.", undefined, "rows", display__display($at(wrong, 0), "length")));
}
limits__raise_all(problems);
}

problems(key, width) {
const self = this; let beyond, edge;

(edge = $mul($mul(0.5, width), $add(1.0, 1e-09)));
(beyond = [...(function* () { for (const y of $iter(self.position)) { if (!(($b.abs(y) > edge))) continue; yield y; } })()]);
if (!$truth(beyond)) {
return [];
}
return [new Problem(("" + "beyond the belt, which reaches from " + $str(display__display($mul($neg(0.5), width), "length")) + " to " + $str(display__display($mul(0.5, width), "length"))), "Give positions from the middle of the belt, and leave out rows beside it.", undefined, key, display__display($at(beyond, 0), "length"))];
}
get largest() {
const self = this; 
return $add($b.max([...$iter(self.value), 0.0]), $b.max($bound(self, "crown"), 0.0));
}
}
class Criteria extends $Object {
$init(take_up = new TakeUp(), standard = new DesignStandard(), safety = new SafetyFactors(), sag = null) { this.take_up = take_up; this.standard = standard; this.safety = safety; this.sag = sag;  }
}
class Layers extends $Object {
$init(pulley_cover, carry_cover, carcass) { this.pulley_cover = pulley_cover; this.carry_cover = carry_cover; this.carcass = carcass;  }
*[Symbol.iterator]() { yield this.pulley_cover; yield this.carry_cover; yield this.carcass; }
}
class Given extends $Object {
$init(name, place, values, raw, diameter, inherited = []) { this.name = name; this.place = place; this.values = values; this.raw = raw; this.diameter = diameter; this.inherited = inherited;  }
static of(name, record, diameter) {
const cls = this; let values;

(values = new LoadGiven(...$iter((function* () { for (const key of $iter($c33)) { yield $m.get(record, key); } })())));
return new cls(name, $bound(record, "place"), values, $bound(record, "raw"), diameter);
}
at(speed) {
const self = this; 
return new DrumAt($bound(self, "diameter"), speed);
}
overridden(record, fixed = false, speed = null, runs = $c78) {
const self = this; let kept, over, own, values;

(over = Given.of($bound(self, "name"), record, $bound(self, "diameter")));
(values = tension_rules__overridden($bound(self, "values"), $bound(over, "values"), fixed, self.at(speed), runs));
(own = $b.zip($c33, values, $bound(self, "values"), $k({strict: true})));
(kept = $b.tuple((function* () { for (const [key, now, before] of $iter(own)) { if (!(((now != null) && (now === before)))) continue; yield key; } })()));
return new Given($bound(self, "name"), $bound(over, "place"), values, $bound(over, "raw"), $bound(self, "diameter"), kept);
}
less_runs(runs, speed) {
const self = this; 
return $replaced(self, new Map([["values", tension_rules__less_runs($bound(self, "values"), runs, self.at(speed))]]));
}
}
class NipTensions extends $Object {
$init(entry, exit) { this.entry = entry; this.exit = exit;  }
*[Symbol.iterator]() { yield this.entry; yield this.exit; }
}
class Tensions extends $Object {
$init(entry, exit, computed = new Map()) { this.entry = entry; this.exit = exit; this.computed = computed; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
(self.exit = load_case__exit_behind($bound(self, "entry"), $bound(self, "exit")));
}
get effective() {
const self = this; 
return $sub(self.entry, self.exit);
}
}
class LoadCase extends $Object {
$init(name, tensions, kind = "running", condition = "") { this.name = name; this.tensions = tensions; this.kind = kind; this.condition = condition; this.__post_init__?.(); }
__post_init__() {
const self = this; let problems;
(problems = criteria__choice_problems(self, $map([["kind", $c79]])));
limits__raise_all($add(limits__name_problems("name", $bound(self, "name")), problems));
}
}
class Viewable extends $Object {


}
class Drive extends Viewable {
$init(title = "", belt, pulleys, load_cases, creep_limit = 0.00635, criteria = new Criteria(), description = "", conveyor = null) { this.title = title; this.belt = belt; this.pulleys = pulleys; this.load_cases = load_cases; this.creep_limit = creep_limit; this.criteria = criteria; this.description = description; this.conveyor = conveyor; this.__post_init__?.(); }
__post_init__() {
const self = this; let case_, key, message, names, problems, pulley;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if (!(1 <= $b.len($bound(self, "pulleys")) && $b.len($bound(self, "pulleys")) <= 10)) {
(message = ("" + "a drive needs 1 to " + $str(10) + " pulleys"));
$m.append(problems, new Problem(message, undefined, undefined, "pulley", $b.str($b.len($bound(self, "pulleys")))));
}
(problems = $add(problems, drive__repeated("pulley", (function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })())));
(problems = $add(problems, drive__repeated("load_case", (function* () { for (const c of $iter(self.load_cases)) { yield c.name; } })())));
(problems = $add(problems, self.criteria.take_up.place_problems([...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()])));
(names = new Set((function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()));
for (case_ of $iter(self.load_cases)) {
if ((!$eq($m.keys(case_.tensions), names))) {
$m.append(problems, drive___wrong_pulleys(case_, names));
}
(problems = $add(problems, drive__condition_problems($bound(case_, "name"), $bound(case_, "condition"), $bound(self, "pulleys"))));
}
(problems = $add(problems, drive__side_problems($bound(self, "belt"), $bound(self, "pulleys"))));
(problems = $add(problems, self._mass_problems()));
for (pulley of $iter(self.pulleys)) {
if ((pulley.across != null)) {
(key = ("" + "pulley." + $str(pulley.name) + ".across"));
(problems = $add(problems, pulley.across.problems(key, $bound(self.belt, "width"))));
}
}
limits__raise_all(problems);
}
_mass_problems() {
const self = this; let key, least, mass, other, problems;

(problems = []);
(mass = self.belt.mass);
if ((mass == null)) {
return problems;
}
if (((self.conveyor != null) && ($b.abs($sub((self.conveyor.belt_mass / mass), 1.0)) > 0.005))) {
(other = display__display($bound(self.conveyor, "belt_mass"), "mass_per_length"));
$m.append(problems, new Problem(("" + "the belt of [conveyor] has belt_mass = " + $str(other)), "Both are the mass of a metre of belt: give one, or the same twice.", undefined, "belt.mass", display__display(mass, "mass_per_length")));
}
for ([key, least] of $iter($m.items(drive__least_tensions($bound(self, "load_cases"))))) {
(problems = $add(problems, drive__flying_problems($bound(self, "belt"), key, least)));
}
return problems;
}
pulley(name = null) {
const self = this; 
return drive__named("pulley", name, $bound(self, "pulleys"));
}
load_case(name = null) {
const self = this; 
if ((name == null)) {
return load_case__heaviest($bound(self, "load_cases"), ((case_) => $math.fsum((function* () { for (const t of $iter($m.values(case_.tensions))) { yield t.effective; } })())));
}
return drive__named("load case", name, $bound(self, "load_cases"));
}
get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.load_cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
}
get laggings() {
const self = this; 
return drive__laggings_of($bound(self, "pulleys"), [...(function* () { for (const case_ of $iter(self.load_cases)) { yield case_.condition; } })()]);
}
in_case(case_) {
const self = this; 
if (!$truth(case_.condition)) {
return self;
}
return $replaced(self, new Map([["pulleys", $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.in_condition($bound(case_, "condition")); } })())]]));
}
slack_end(case_) {
const self = this; let first, last, pull;

([first, last] = (function* () { for (const p of $iter([$at(self.pulleys, 0), $at(self.pulleys, $neg(1))])) { yield $at(case_.tensions, p.name); } })());
(pull = $math.fsum((function* () { for (const t of $iter($m.values(case_.tensions))) { yield t.effective; } })()));
return ((pull >= 0.0) ? last.exit : first.entry);
}
take_up_tension(case_) {
const self = this; let after;

(after = self.criteria.take_up.after);
return ($truth(after) ? $at(case_.tensions, after).exit : self.slack_end(case_));
}
creep_limit_of(pulley) {
const self = this; 
return ((pulley.creep_limit == null) ? self.creep_limit : pulley.creep_limit);
}
}
class Train extends $Object {
$init(title = "", description = "", belt, pulleys, cases, nominal_diameters = [], creep_limit = 0.00635, criteria = new Criteria()) { this.title = title; this.description = description; this.belt = belt; this.pulleys = pulleys; this.cases = cases; this.nominal_diameters = nominal_diameters; this.creep_limit = creep_limit; this.criteria = criteria; this.__post_init__?.(); }
__post_init__() {
const self = this; let case_, count, given, least, message, names, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(count = $b.len($bound(self, "pulleys")));
if (!(1 <= count && count <= 10)) {
(message = ("" + "a train needs 1 to " + $str(10) + " pulleys"));
$m.append(problems, new Problem(message, undefined, undefined, "pulley", $b.str(count)));
}
(problems = $add(problems, drive__repeated("pulley", (function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })())));
(problems = $add(problems, drive__repeated("load_case", (function* () { for (const c of $iter(self.cases)) { yield c.name; } })())));
(problems = $add(problems, self.criteria.take_up.place_problems([...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()])));
if (!$truth(self.cases)) {
$m.append(problems, new Problem("a train needs a load case", undefined, undefined, "load_case"));
}
if ($truth(self.nominal_diameters)) {
(problems = $add(problems, train___count_problems("nominal_diameters", $bound(self, "nominal_diameters"), count)));
if (!$truth($b.all((function* () { for (const d of $iter(self.nominal_diameters)) { yield (0.0 < d && d < Infinity); } })()))) {
(message = "must be positive and finite");
(given = $b.str($b.list($bound(self, "nominal_diameters"))));
$m.append(problems, new Problem(message, undefined, undefined, "nominal_diameters", given));
}
}
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for (case_ of $iter(self.cases)) {
(problems = $add(problems, train___case_problems(case_, names)));
(problems = $add(problems, drive__condition_problems($bound(case_, "name"), $bound(case_, "condition"), $bound(self, "pulleys"))));
(least = $b.min($bound(case_, "entry_tension"), $bound(case_, "exit_tension")));
(problems = $add(problems, drive__flying_problems($bound(self, "belt"), ("" + "load_case." + $str(case_.name)), least)));
}
(problems = $add(problems, drive__side_problems($bound(self, "belt"), $bound(self, "pulleys"))));
limits__raise_all(problems);
}
static of(drive) {
const cls = this; 
return $call(cls, [], [["title", drive.title], ["description", drive.description], ["belt", drive.belt], ["pulleys", drive.pulleys], ["cases", $b.tuple((function* () { for (const case_ of $iter(drive.load_cases)) { yield train___case_of(drive, case_); } })())], ["creep_limit", drive.creep_limit], ["criteria", drive.criteria]]);
}
get nominal() {
const self = this; 
return $or(self.nominal_diameters, () => $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.diameter; } })()));
}
case(name = "") {
const self = this; 
if (!$truth(name)) {
return load_case__heaviest($bound(self, "cases"), ((case_) => $sub(case_.entry_tension, case_.exit_tension)));
}
return drive__named("load case", name, $bound(self, "cases"), "the train");
}
get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
}
get laggings() {
const self = this; 
return drive__laggings_of($bound(self, "pulleys"), [...(function* () { for (const case_ of $iter(self.cases)) { yield case_.condition; } })()]);
}
in_case(case_) {
const self = this; 
if (!$truth(case_.condition)) {
return self;
}
return $replaced(self, new Map([["pulleys", $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.in_condition($bound(case_, "condition")); } })())]]));
}
creep_limit_of(pulley) {
const self = this; 
return ((pulley.creep_limit == null) ? self.creep_limit : pulley.creep_limit);
}
}
class Reader extends $Object {
$init(record, belt, pulleys, report, take_up) {
const self = this; ([self.belt, self.pulleys, self._report, self._take_up] = [belt, pulleys, report, take_up]);
(self._record = record);
(self._train = $at(record, "train"));
(self.nominal = $b.tuple((function* () { for (const p of $iter(pulleys)) { yield p.diameter; } })()));
(self.actual = self._with_actual_diameters());
}
_with_actual_diameters() {
const self = this; let diameters;
(diameters = $m.get(self._train, "diameters"));
if (((diameters == null) || !$truth(self._counted($bound(self, "_train"), "diameters")))) {
return $b.tuple($bound(self, "pulleys"));
}
return $b.tuple((function* () { for (const [pulley, d] of $iter($b.zip($bound(self, "pulleys"), diameters, $k({strict: true})))) { yield $replaced(pulley, new Map([["diameter", d]])); } })());
}
_counted(record, key) {
const self = this; let message;

if (($eq($b.len($at(record, key)), $b.len($bound(self, "pulleys"))))) {
return true;
}
(message = ("" + "must have one value for each of the " + $str($b.len($bound(self, "pulleys"))) + " pulleys, in belt order"));
$method(self._report, "add", [[...$iter(record.place), key], message], [["value", $at(record.raw, key)]]);
return false;
}
cases() {
const self = this; let built, case_, empty, over, speed, table, tables, train;

([train, speed] = [self._train, self.belt.speed]);
(tables = [...(function* () { for (const c of $iter($or($m.get(self._record, "load_case"), () => []))) { if (!($truth($b.isinstance(c, Record)))) continue; yield c; } })()]);
(built = []);
if ((!$truth(tables) || $truth(tensions__complete([self._given(train, null)], speed)) || $truth(self._powers(train)))) {
$m.append(built, self._case("design", train, null));
}
for (table of $iter(tables)) {
(over = $m.get(table, "train"));
(empty = new Record($map([]), [...$iter(table.place), "train"], $map([])));
(case_ = self._case($at(table, "name"), train, ((over != null) ? over : empty)));
$m.append(built, $and(case_, () => $replaced(case_, new Map([["kind", $m.get(table, "kind", "running")], ["condition", conditions__condition_name(table)]]))));
}
return [...(function* () { for (const case_ of $iter(built)) { if (!((case_ != null))) continue; yield case_; } })()];
}
_case(name, train, over) {
const self = this; let division, error, given, message, place, pull, runs, tensions, total;
(place = ((over == null) ? train.place : over.place));
(runs = self._runs(train, over));
(division = self._division(train, over));
(given = self._given(train, over));
(pull = self._powers((((over == null) || (!$in("share", over))) ? train : over)));
if (($truth(pull) && ($b.len(tension_rules__families($bound(given, "values"))) < 2))) {
(given = $replaced(given, new Map([["values", $replaced(given.values, new Map([["effective_tension", pull]]))]])));
}
(given = given.less_runs($b.sum(runs), $bound(self.belt, "speed")));
(given = self._held(given, train, over, runs, division));
(tensions = $m.get(tensions__resolve([given], $bound(self.belt, "speed"), $bound(self, "_report")), $bound(given, "name")));
if (((division == null) || (tensions == null))) {
return null;
}
(total = $add(tensions.effective, $b.sum(runs)));
if (($truth(pull) && ($b.abs($sub(total, pull)) > $mul(0.005, $b.abs(pull))))) {
(message = ("" + "the powers make a pull of " + $str(display__display(pull, "force")) + " at the belt speed, and the tensions one of " + $str(display__display(total, "force"))));
self._report.add([...$iter(place), "share"], message, "Leave one of them out.");
return null;
}
try {
return new TrainCase(name, tensions.entry, tensions.exit, division, ($truth($b.any(runs)) ? runs : []));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self._report.take(error, place);
return null;
} else throw $error;
}
}
_given(train, over) {
const self = this; let fixed, given, runs;
(given = Given.of("train", train, null));
if ((over == null)) {
return given;
}
([runs, fixed] = [$c78, self._take_up.fixed]);
if ($truth(fixed)) {
(runs = new RunsGain($b.sum(self._runs(train, null)), $b.sum(self._runs(train, over))));
}
return $method(given, "overridden", [over], [["fixed", fixed], ["speed", self.belt.speed], ["runs", runs]]);
}
_held(given, train, over, runs, division) {
const self = this; let after, base, ends, first, k, message, names, own, remedy;

([names, after] = [[...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()], self._take_up.after]);
if (((over == null) || (!$in(after, $slice(names, null, $neg(1)))) || ($in("entry_tension", over)) || ($in("exit_tension", over)))) {
return given;
}
if (((division == null) || !$truth($b.any((function* () { for (const key of $iter([...$iter($c80), ...$iter($c81), "run"])) { yield ($in(key, over)); } })())))) {
return given;
}
([own, base] = [self._runs(train, null), self._division(train, null)]);
if ((!$truth($b.isinstance(division, Shares)) || !$truth($b.isinstance(base, Shares)))) {
(message = "gives its pull alone, and how much of it the drives behind the take-up take follows from their speeds or motors");
(remedy = ("" + "Give exit_tension too, so that the belt behind " + $str(after) + " keeps its tension."));
self._report.add($bound(over, "place"), message, remedy);
return given;
}
(first = self._given(train, null).less_runs($b.sum(own), $bound(self.belt, "speed")));
(k = $add($m.index(names, after), 1));
(ends = tension_rules__behind_take_up(self._ends(given), self._ends(first), new BehindTakeUp($math.fsum($slice(division.fractions, k, null)), $b.sum($slice(runs, $sub(k, 1), null)), $b.sum(runs)), new BehindTakeUp($math.fsum($slice(base.fractions, k, null)), $b.sum($slice(own, $sub(k, 1), null)), $b.sum(own))));
if ((ends == null)) {
return given;
}
return $replaced(given, new Map([["values", new LoadGiven($bound(ends, "entry"), $bound(ends, "exit"))], ["inherited", []]]));
}
_ends(given) {
const self = this; return tension_rules__ends_of($bound(given, "values"), given.at($bound(self.belt, "speed")));
}
_runs(train, over) {
const self = this; let message, name, names, place, places, remedy, table, there;
(table = $b.dict($m.get(train, "run", $map([]))));
(places = $b.fromkeys(table, train.place));
if ((over != null)) {
(table = $merged(table, $m.get(over, "run", $map([]))));
(places = $merged(places, $b.fromkeys($m.get(over, "run", $map([])), over.place)));
}
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for ([name, place] of $iter($m.items(places))) {
if ((!$in(name, $slice(names, 1, null)))) {
(there = $m.join(", ", $b.map($shown, $slice(names, 1, null))));
(message = (($in(name, names)) ? "the first pulley has no run before it" : ("" + "no such pulley; runs lead to " + $str(there))));
(remedy = errors__nearest(name, $slice(names, 1, null)));
self._report.add([...$iter(place), "run", name], message, remedy);
}
}
return $b.tuple((function* () { for (const name of $iter($slice(names, 1, null))) { yield $m.get(table, name, 0.0); } })());
}
_division(train, over) {
const self = this; let message, modes, record;

(record = train);
if (((over != null) && $truth($b.any((function* () { for (const mode of $iter($c81)) { yield ($in(mode, over)); } })())))) {
(record = over);
}
(modes = [...(function* () { for (const mode of $iter($c81)) { if (!(($in(mode, record)))) continue; yield mode; } })()]);
if (($b.len(modes) > 1)) {
(message = ("" + $str($m.join(" and ", modes)) + " each decide how the load divides"));
self._report.add($bound(record, "place"), message, "Keep one of them.");
return null;
}
if (!$truth(modes)) {
if (($in("diameters", train))) {
return new Speeds($b.tuple((function* () { for (const d of $iter(self.nominal)) { yield (1.0 / d); } })()));
}
if (($eq($b.len($bound(self, "pulleys")), 1))) {
return new Shares([1.0]);
}
self._report.add($bound(record, "place"), "nothing says how the load divides", "Write share = [\"50 %\", \"50 %\"], speeds = \"equal\", or a [train.motor.NAME] for each pulley.");
return null;
}
if (($eq(modes, ["motor"]))) {
return self._motors($at(record, "motor"), train);
}
return (($eq(modes, ["share"])) ? self._shares(record) : self._speeds(record));
}
_shares(record) {
const self = this; let kind, message, total, values;
if ((!$truth(self._counted(record, "share")) || !$truth(self._one_kind(record, "share")))) {
return null;
}
([kind, values] = [$at($at($at(record, "share"), 0), 0), [...(function* () { for (const [_, value] of $iter($at(record, "share"))) { yield value; } })()]]);
(total = (($eq(kind, "power")) ? $math.fsum(values) : 1.0));
if (($eq(total, 0.0))) {
(message = "the powers sum to 0, so that there is nothing to share");
$method(self._report, "add", [[...$iter(record.place), "share"], message], [["value", $at(record.raw, "share")]]);
return null;
}
return new Shares($b.tuple((function* () { for (const value of $iter(values)) { yield (value / total); } })()));
}
_powers(record) {
const self = this; let values;

(values = $m.get(record, "share"));
if ((!$truth(values) || ($in($c7, values)) || (!$eq($at($at(values, 0), 0), "power")) || !$truth(self.belt.speed))) {
return null;
}
return ($math.fsum((function* () { for (const [_, value] of $iter(values)) { yield value; } })()) / self.belt.speed);
}
_speeds(record) {
const self = this; let kind, values;
if (($eq($at(record, "speeds"), "equal"))) {
return new Speeds($mul([1.0], $b.len($bound(self, "pulleys"))));
}
if ((!$truth(self._counted(record, "speeds")) || !$truth(self._one_kind(record, "speeds")))) {
return null;
}
([kind, values] = [$at($at($at(record, "speeds"), 0), 0), [...(function* () { for (const [_, value] of $iter($at(record, "speeds"))) { yield value; } })()]]);
if (($eq(kind, "rotation_speed"))) {
return new Speeds($b.tuple(values), true);
}
return new Speeds($b.tuple((function* () { for (const [v, d] of $iter($b.zip(values, $bound(self, "nominal"), $k({strict: true})))) { yield (v / d); } })()));
}
_one_kind(record, key) {
const self = this; let message;
if (($eq($b.len(new Set((function* () { for (const [kind, _] of $iter($at(record, key))) { yield kind; } })())), 1))) {
return true;
}
(message = "must be all of one kind");
$method(self._report, "add", [[...$iter(record.place), key], message], [["value", $at(record.raw, key)]]);
return false;
}
_motors(tables, train) {
const self = this; let made, message, missing, motors, name, names, remedy;
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for (name of $iter((function* () { for (const name of $iter(tables)) { if (!((!$in(name, names)))) continue; yield name; } })())) {
(message = ("" + "no such pulley; the pulleys are " + $str($m.join(", ", $b.map($shown, names)))));
self._report.add([...$iter(train.place), "motor", name], message, errors__nearest(name, names));
}
(missing = [...(function* () { for (const name of $iter(names)) { if (!((!$in(name, tables)))) continue; yield name; } })()]);
for (name of $iter(missing)) {
(remedy = ("" + "Write [train.motor." + $str(name) + "] with kind = \"" + $str($b.next($b.iter($c82))) + "\"."));
self._report.add([...$iter(train.place), "motor", name], "missing", remedy);
}
if (($truth(missing) || (!$eq($b.len(tables), $b.len(names))))) {
return null;
}
(motors = [...(function* () { for (const name of $iter(names)) { yield self._motor($at(tables, name)); } })()]);
(made = $b.tuple((function* () { for (const motor of $iter(motors)) { if (!((motor != null))) continue; yield motor; } })()));
return (($eq($b.len(made), $b.len(names))) ? new Motors(made) : null);
}
_motor(record) {
const self = this; let motor;
(motor = $c83.built(record, $bound(self, "_report")));
return motor;
}
}
class CatalogueBelt extends $Object {
$init(name, kind, rating, modulus, least_pulley_diameter = null, carcass = null, carcass_mass = null, cover_mass = null, provenance, carcass_source = null) { this.name = name; this.kind = kind; this.rating = rating; this.modulus = modulus; this.least_pulley_diameter = least_pulley_diameter; this.carcass = carcass; this.carcass_mass = carcass_mass; this.cover_mass = cover_mass; this.provenance = provenance; this.carcass_source = carcass_source;  }
get sources() {
const self = this; 
return ($truth(self.carcass_source) ? $map([["carcass", self.carcass_source]]) : $map([]));
}
}
class WrapArc extends $Object {
$init(law, entry_tension, exit_tension, diameter, wrap_angle, width, axial_stiffness, thickness = 0.0, shear_modulus = Infinity, compression_modulus = Infinity, overrun = null, recovery = true, creep_limit = 0.00635, belt_speed = null, wear_coefficient = null, pitch_offset = null, cover_compliance = 0.0, cover_left_out = 0.0, side_of_belt = "pulley", belt_thickness = null, centrifugal = 0.0, fit = null, pulley = "", load_case = "") { this.law = law; this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.diameter = diameter; this.wrap_angle = wrap_angle; this.width = width; this.axial_stiffness = axial_stiffness; this.thickness = thickness; this.shear_modulus = shear_modulus; this.compression_modulus = compression_modulus; this.overrun = overrun; this.recovery = recovery; this.creep_limit = creep_limit; this.belt_speed = belt_speed; this.wear_coefficient = wear_coefficient; this.pitch_offset = pitch_offset; this.cover_compliance = cover_compliance; this.cover_left_out = cover_left_out; this.side_of_belt = side_of_belt; this.belt_thickness = belt_thickness; this.centrifugal = centrifugal; this.fit = fit; this.pulley = pulley; this.load_case = load_case; this.__post_init__?.(); }
__post_init__() {
const self = this; let ends, key, least, message, most, problems, unit, value;
(problems = [...(function* () { for (const [key, value, unit] of $iter([["entry_tension", self.entry_tension, "N"], ["exit_tension", self.exit_tension, "N"], ["diameter", self.diameter, "m"], ["wrap_angle", self.wrap_angle, "rad"], ["width", self.width, "m"], ["creep_limit", self.creep_limit, "m"]])) { if (!(!(0.0 < value && value < Infinity))) continue; yield new Problem("must be positive and finite", undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))); } })()]);
if (!(0.0 <= self.thickness && self.thickness < Infinity)) {
(message = "must be 0 or positive, and finite");
$m.append(problems, new Problem(message, undefined, undefined, "thickness", ("" + $format(self.thickness, ("" + "g")) + " m")));
}
if (((self.overrun != null) && !$truth($math.isfinite($bound(self, "overrun"))))) {
(message = "must be finite");
$m.append(problems, new Problem(message, undefined, undefined, "overrun", ("" + $format(self.overrun, ("" + "g")) + " m")));
}
(problems = $add(problems, [...(function* () { for (const [key, value, unit] of $iter([["axial_stiffness", self.axial_stiffness, "N"], ["shear_modulus", self.shear_modulus, "Pa"], ["compression_modulus", self.compression_modulus, "Pa"]])) { if (!(!(value > 0.0))) continue; yield new Problem("must be positive", undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))); } })()]));
(least = $b.min($bound(self, "entry_tension"), $bound(self, "exit_tension")));
(least = ((least > 0.0) ? least : Infinity));
for ([key, value, unit, most] of $iter([["pitch_offset", $or(self.pitch_offset, () => 0.0), "m", Infinity], ["cover_compliance", self.cover_compliance, "m/Pa", Infinity], ["centrifugal", self.centrifugal, "N", least]])) {
if (!(0.0 <= value && value < most)) {
(ends = $add("at least 0", (($eq(most, Infinity)) ? "" : ", and less than the tensions")));
(message = ("" + "must be " + $str(ends)));
$m.append(problems, new Problem(message, undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))));
}
}
if (!$truth(problems)) {
(problems = self._law_problems());
}
if ($truth(problems)) {
throw new InputError(problems);
}
}
_law_problems() {
const self = this; let fall, held, law, problems, top;
(problems = []);
(top = self.wrap_pressure($b.max($bound(self, "entry_tension"), $bound(self, "exit_tension"))));
if ($truth(summary__too_steep(self.described(), self.law.steepest_fall()))) {
(fall = ($neg(1.0) / $mul(self.shear_compliance, top)));
$m.append(problems, new Problem(("" + "friction falls so steeply past its peak that slip and shear of the lagging are not unique; at " + $format(top, ("" + "g")) + " Pa the slope must stay above " + $format(fall, ("" + "g")) + " 1/m (-G/(h p))"), "Check the unit of the slope, the thickness and the shear modulus.", undefined, "lagging", ("" + "post_peak_slope " + $format(self.law.steepest_fall(), ("" + "g")) + " 1/m")));
}
(law = self.law.compact());
if ($truth(summary__overrun_loosens(law, self.geometry(), $bound(self, "entry_pressure")))) {
(held = summary__held_creep(law, $bound(self, "shear_compliance"), $bound(self, "entry_pressure")));
$m.append(problems, new Problem(("" + "this friction law holds the belt without slip up to a creep of " + $format(held, ("" + "g")) + " m; with an overrun beyond that the creep of a belt that comes to rest again is not unique"), "Set overrun = \"0 mm\" for this law.", undefined, "overrun", ("" + $format(self.entry_overrun, ("" + "g")) + " m")));
}
return problems;
}
static of(drive, pulley, case_) {
const cls = this; let lagging, tensions;

([lagging, tensions] = [pulley.lagging_in($bound(case_, "condition")), $at(case_.tensions, pulley.name)]);
return $call(cls, [], [["law", lagging.law], ...wrap_arc__of_belt($bound(drive, "belt"), $bound(pulley, "side"), $bound(lagging, "law")), ["entry_tension", tensions.entry], ["exit_tension", tensions.exit], ["diameter", pulley.diameter], ["wrap_angle", pulley.wrap_angle], ["width", drive.belt.width], ["axial_stiffness", drive.belt.axial_stiffness], ["thickness", lagging.thickness], ["shear_modulus", lagging.shear_modulus], ["compression_modulus", lagging.compression_modulus], ["overrun", pulley.overrun], ["recovery", pulley.recovery], ["creep_limit", drive.creep_limit_of(pulley)], ["belt_speed", drive.belt.speed], ["wear_coefficient", lagging.wear_coefficient], ["fit", lagging.fit], ["pulley", pulley.name], ["load_case", case_.name]]);
}
get radius() {
const self = this; 
return $mul(0.5, self.diameter);
}
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
get side() {
const self = this; 
return ((self.entry_tension >= self.exit_tension) ? 1.0 : $neg(1.0));
}
wrap_pressure(tension) {
const self = this; 
return ($mul(2.0, $sub(tension, self.centrifugal)) / $mul(self.width, self.diameter));
}
get entry_pressure() {
const self = this; 
return self.wrap_pressure($bound(self, "entry_tension"));
}
get offset() {
const self = this; 
return $or(self.pitch_offset, () => 0.0);
}
get shear_compliance() {
const self = this; 
return $add(self.lagging_compliance, self.cover_compliance);
}
get lagging_compliance() {
const self = this; 
return ($truth(self.slip_with_shear) ? 0.0 : (self.thickness / self.shear_modulus));
}
get slip_with_shear() {
const self = this; 
return (pitch__counts_shear($bound(self, "law"), "lagging shear") === true);
}
get compliance() {
const self = this; 
return $add((1.0 / self.axial_stiffness), self.recovery_compliance);
}
get entry_overrun() {
const self = this; let found, pressure;

([found, pressure] = [self.geometry(), self.entry_pressure]);
return $add(found.overrun_constant, $mul($mul(found.overrun_coefficient, pressure), $math.sqrt(pressure)));
}
described() {
const self = this; 
return new Description(self.entry_tension, self.exit_tension, self.diameter, self.wrap_angle, self.width, self.axial_stiffness, self.thickness, self.shear_modulus, self.compression_modulus, ((self.overrun == null) ? NaN : self.overrun), self.recovery, ((self.belt_speed == null) ? NaN : self.belt_speed), ((self.wear_coefficient == null) ? NaN : self.wear_coefficient), self.shear_compliance, self.offset, self.centrifugal);
}
geometry() {
const self = this; 
return summary__geometry_of(self.described());
}
get recovery_compliance() {
const self = this; 
return summary__recovery_compliance(self.described());
}
load() {
const self = this; let ends, tested;

(tested = self.law.tested);
(ends = [NaN, NaN, NaN]);
if ((tested != null)) {
(ends = [tested.pressure_min, tested.pressure_max, tested.slip_max]);
}
return new Load($sub(self.entry_tension, self.centrifugal), $sub(self.exit_tension, self.centrifugal), $bound(self, "creep_limit"), ...$iter(ends), self.law.steepest_fall());
}
get length() {
const self = this; 
return $mul(self.radius, self.wrap_angle);
}
}
class in_page$Given extends $Object {
$init(entry_tension, exit_tension, effective_tension, torque, power, diameter, wrap_angle, overrun, recovery, width, modulus, speed, thickness, shear_modulus, compression_modulus, wear_coefficient, creep_limit, steepest_fall, pitch_offset, cover_compliance, mass, slip_with_shear, belt_speed) { this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.effective_tension = effective_tension; this.torque = torque; this.power = power; this.diameter = diameter; this.wrap_angle = wrap_angle; this.overrun = overrun; this.recovery = recovery; this.width = width; this.modulus = modulus; this.speed = speed; this.thickness = thickness; this.shear_modulus = shear_modulus; this.compression_modulus = compression_modulus; this.wear_coefficient = wear_coefficient; this.creep_limit = creep_limit; this.steepest_fall = steepest_fall; this.pitch_offset = pitch_offset; this.cover_compliance = cover_compliance; this.mass = mass; this.slip_with_shear = slip_with_shear; this.belt_speed = belt_speed;  }
*[Symbol.iterator]() { yield this.entry_tension; yield this.exit_tension; yield this.effective_tension; yield this.torque; yield this.power; yield this.diameter; yield this.wrap_angle; yield this.overrun; yield this.recovery; yield this.width; yield this.modulus; yield this.speed; yield this.thickness; yield this.shear_modulus; yield this.compression_modulus; yield this.wear_coefficient; yield this.creep_limit; yield this.steepest_fall; yield this.pitch_offset; yield this.cover_compliance; yield this.mass; yield this.slip_with_shear; yield this.belt_speed; }
}
class Rise extends $Object {
$init(tight, slack) { this.tight = tight; this.slack = slack;  }
}
class in_page$Criteria extends $Object {
$init(safety, tight_rise, slack_rise, cover, strength, pulley_mass, wet) { this.safety = safety; this.tight_rise = tight_rise; this.slack_rise = slack_rise; this.cover = cover; this.strength = strength; this.pulley_mass = pulley_mass; this.wet = wet;  }
*[Symbol.iterator]() { yield this.safety; yield this.tight_rise; yield this.slack_rise; yield this.cover; yield this.strength; yield this.pulley_mass; yield this.wet; }
}
class ArcResult extends Viewable {
$init(status, method, arc, profile, entry_tension, exit_tension, exit_creep, creep_shrinkage, creep_compression, creep_global, exit_slip, entry_creep_ratio, exit_creep_ratio, peak_shear_stress, peak_shear_angle, peak_shear_position, mean_friction, active_arc, outside_tested_share, stuck_arc, capacities, energy) { this.status = status; this.method = method; this.arc = arc; this.profile = profile; this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.exit_creep = exit_creep; this.creep_shrinkage = creep_shrinkage; this.creep_compression = creep_compression; this.creep_global = creep_global; this.exit_slip = exit_slip; this.entry_creep_ratio = entry_creep_ratio; this.exit_creep_ratio = exit_creep_ratio; this.peak_shear_stress = peak_shear_stress; this.peak_shear_angle = peak_shear_angle; this.peak_shear_position = peak_shear_position; this.mean_friction = mean_friction; this.active_arc = active_arc; this.outside_tested_share = outside_tested_share; this.stuck_arc = stuck_arc; this.capacities = capacities; this.energy = energy;  }
get covered_creep() { return $kept(this, "covered_creep", this.$find_covered_creep()); }
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
$find_covered_creep() {
const self = this; let arc, found, geometry, load, series;

(arc = self.arc);
if ((!$truth($told($c40, self.status, "solved")) || ($eq(arc.cover_left_out, 0.0)))) {
return NaN;
}
([load, geometry] = [arc.load(), arc.geometry()]);
(series = $replaced(geometry, new Map([["shear", $add(geometry.shear, arc.cover_left_out)]])));
(found = answer__operating_point(arc.law.compact(), series, $bound(load, "entry_tension"), $bound(load, "exit_tension")));
if ((!$eq(found.outcome, 0))) {
return $math.copysign(Infinity, $bound(arc, "side"));
}
return $at(found.met.course.creep, $neg(1));
}
}
class FoundArc extends ArcResult {
$init(status, method, arc, profile, entry_tension, exit_tension, exit_creep, creep_shrinkage, creep_compression, creep_global, exit_slip, entry_creep_ratio, exit_creep_ratio, peak_shear_stress, peak_shear_angle, peak_shear_position, mean_friction, active_arc, outside_tested_share, stuck_arc, capacities, energy, found) { this.status = status; this.method = method; this.arc = arc; this.profile = profile; this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.exit_creep = exit_creep; this.creep_shrinkage = creep_shrinkage; this.creep_compression = creep_compression; this.creep_global = creep_global; this.exit_slip = exit_slip; this.entry_creep_ratio = entry_creep_ratio; this.exit_creep_ratio = exit_creep_ratio; this.peak_shear_stress = peak_shear_stress; this.peak_shear_angle = peak_shear_angle; this.peak_shear_position = peak_shear_position; this.mean_friction = mean_friction; this.active_arc = active_arc; this.outside_tested_share = outside_tested_share; this.stuck_arc = stuck_arc; this.capacities = capacities; this.energy = energy; this.found = found;  }
get covered_creep() {
const self = this; 
return self.found.covered_creep;
}
}
class DriveResult extends Viewable {
$init(drive, arcs) { this.drive = drive; this.arcs = arcs;  }
__iter__() {
const self = this; return $b.iter($bound(self, "arcs"));
}
arc(pulley, load_case = "") {
const self = this; let result;

for (result of $iter(self.arcs)) {
if ((($eq(result.arc.pulley, pulley)) && ($in(load_case, ["", result.arc.load_case])))) {
return result;
}
}
throw new $KeyError([pulley, load_case]);
}
get governing() {
const self = this; let worst;

function severity(result) {
let margin;
if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return [2.0, 0.0];
}
if ((result.status === "Breakaway: no creep makes enough friction for this tension ratio. Raise the slack-side tension (take-up), enlarge the wrap angle, or choose a lagging with more friction.")) {
(margin = result.capacities.gross_slip_margin);
return [1.0, ($truth($math.isfinite(margin)) ? $neg(margin) : 0.0)];
}
return [0.0, ($b.abs($bound(result, "exit_creep")) / result.arc.creep_limit)];
}
$sig(severity, ["result"], false);
(worst = $b.max((function* () { for (const result of $iter(self.arcs)) { yield $at(severity(result), 0); } })()));
return alike__largest((function* () { for (const result of $iter(self.arcs)) { if (!(($eq($at(severity(result), 0), worst)))) continue; yield result; } })(), ((result) => $at(severity(result), 1)));
}
get solved() {
const self = this; 
return $b.all((function* () { for (const r of $iter(self.arcs)) { yield $told($c40, r.status, "solved"); } })());
}
}
class TrainResult extends Viewable {
$init(train, cases) { this.train = train; this.cases = cases;  }
__iter__() {
const self = this; return $b.iter($bound(self, "cases"));
}
get adrift() {
const self = this; 
return $b.any((function* () { for (const c of $iter(self.cases)) { yield c.adrift; } })());
}
get solved() {
const self = this; 
return $b.all((function* () { for (const c of $iter(self.cases)) { yield $told($c40, c.status, "solved"); } })());
}
get governing() {
const self = this; let solved;

function severity(case_) {
let creeps;
(creeps = [...(function* () { for (const m of $iter(case_.members)) { yield ($b.abs($bound(m.arc, "exit_creep")) / m.arc.arc.creep_limit); } })()]);
return $b.max((function* () { for (const c of $iter(creeps)) { yield ($truth($math.isfinite(c)) ? c : 0.0); } })());
}
$sig(severity, ["case"], false);
(solved = $told($c40, self, "solved"));
return alike__largest((function* () { for (const c of $iter(self.cases)) { if (!(($truth(solved) || !$truth($told($c40, c.status, "solved"))))) continue; yield c; } })(), severity);
}
drive_result() {
const self = this; let arcs, cases;

(cases = [...(function* () { for (const result of $iter(self.cases)) { yield new LoadCase(result.case.name, $map([...(function* () { for (const m of $iter(result.members)) { yield [m.name, new Tensions(m.arc.entry_tension, m.arc.exit_tension)]; } })()]), result.case.kind, result.case.condition); } })()]);
(arcs = $b.tuple((function* () { for (const case_ of $iter(self.cases)) { for (const m of $iter(case_.members)) { yield m.arc; }} })()));
return new DriveResult(result__drive_with($bound(self, "train"), cases), arcs);
}
}
class CaseResult extends $Object {
$init(case_, status, reason, members, sensitivity, belt_speed, other_splits = [], tension_error = 0.0, speed_error = 0.0) { this.case = case_; this.status = status; this.reason = reason; this.members = members; this.sensitivity = sensitivity; this.belt_speed = belt_speed; this.other_splits = other_splits; this.tension_error = tension_error; this.speed_error = speed_error;  }
__iter__() {
const self = this; return $b.iter($bound(self, "members"));
}
get adrift() {
const self = this; 
return $and((self.status === "Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction."), () => !$truth(self.case.pulls_given));
}
}
class MemberResult extends $Object {
$init(arc, share, speed_ratio, contraction_term, creep_term, compression_term, thickness_term, drum_ratio, surface_speed, rotation_speed, speed_trim, drum_torque, drum_power, motor = null) { this.arc = arc; this.share = share; this.speed_ratio = speed_ratio; this.contraction_term = contraction_term; this.creep_term = creep_term; this.compression_term = compression_term; this.thickness_term = thickness_term; this.drum_ratio = drum_ratio; this.surface_speed = surface_speed; this.rotation_speed = rotation_speed; this.speed_trim = speed_trim; this.drum_torque = drum_torque; this.drum_power = drum_power; this.motor = motor;  }
get name() {
const self = this; 
return self.arc.arc.pulley;
}
}
class Place extends $Object {
$init(pulley = "", load_case = "", event = "") { this.pulley = pulley; this.load_case = load_case; this.event = event;  }
*[Symbol.iterator]() { yield this.pulley; yield this.load_case; yield this.event; }
__str__() {
const self = this; let parts;
(parts = ($truth(self.pulley) ? [("" + "pulley " + $str(self.pulley))] : []));
(parts = $add(parts, ($truth(self.load_case) ? [("" + "load case " + $str(self.load_case))] : [])));
(parts = $add(parts, ($truth(self.event) ? [("" + "event " + $str(self.event))] : [])));
return $m.join(", ", parts);
}
}
class Sizes extends $Object {
$init(width, modulus, speed, diameter, idle_wrap, wrap_angle, creep_limit, overrun, thickness, shear_modulus, compression_modulus, rating, strength, bond_strength, fatigue_limit, face_pressure, least_diameter, sag, entry, leaving, pull, mass) { this.width = width; this.modulus = modulus; this.speed = speed; this.diameter = diameter; this.idle_wrap = idle_wrap; this.wrap_angle = wrap_angle; this.creep_limit = creep_limit; this.overrun = overrun; this.thickness = thickness; this.shear_modulus = shear_modulus; this.compression_modulus = compression_modulus; this.rating = rating; this.strength = strength; this.bond_strength = bond_strength; this.fatigue_limit = fatigue_limit; this.face_pressure = face_pressure; this.least_diameter = least_diameter; this.sag = sag; this.entry = entry; this.leaving = leaving; this.pull = pull; this.mass = mass;  }
*[Symbol.iterator]() { yield this.width; yield this.modulus; yield this.speed; yield this.diameter; yield this.idle_wrap; yield this.wrap_angle; yield this.creep_limit; yield this.overrun; yield this.thickness; yield this.shear_modulus; yield this.compression_modulus; yield this.rating; yield this.strength; yield this.bond_strength; yield this.fatigue_limit; yield this.face_pressure; yield this.least_diameter; yield this.sag; yield this.entry; yield this.leaving; yield this.pull; yield this.mass; }
}
class Check extends $Object {
$init(name, title, level, place = $c87, value = NaN, limit = NaN, dimension = "number", at_most = true, source = "", short = "", says = "", remedy = "", otherwise = "", more = new Map(), binding = true, miss = null) { this.name = name; this.title = title; this.level = level; this.place = place; this.value = value; this.limit = limit; this.dimension = dimension; this.at_most = at_most; this.source = source; this.short = short; this.says = says; this.remedy = remedy; this.otherwise = otherwise; this.more = more; this.binding = binding; this.miss = miss;  }
get margin() {
const self = this; 
return ($truth(self.below) ? 1.0 : numbers__margin_of($bound(self, "value"), $bound(self, "limit"), $bound(self, "at_most")));
}
get compares() {
const self = this; 
return $and((!$in(self.name, $c84)), () => (self.level !== "NOT CHECKED"));
}
get below() {
const self = this; 
return $and(self.numerical, () => (self.level === "OK"));
}
get share() {
const self = this; let share, silent;

(silent = $or((self.level === "NOT CHECKED"), () => $or(self.numerical, () => !$truth(self.limit))));
(share = ($truth(silent) ? NaN : (self.value / self.limit)));
return ($truth($math.isfinite(share)) ? share : NaN);
}
get reason() {
const self = this; 
return ($truth(self.missed) ? $replaced(self, new Map([["remedy", ""]])).said : "");
}
get times() {
const self = this; 
return numbers__times_of($bound(self, "value"), $bound(self, "limit"));
}
get missed() {
const self = this; 
return ($told($c85, self.level, "rank") >= $told($c85, "ATTENTION", "rank"));
}
texts() {
const self = this; let limit;

if ($truth(self.below)) {
(limit = check__quantity_text($bound(self, "limit"), $bound(self, "dimension")));
return [("" + "below " + $str(limit)), limit];
}
if (!$truth(self.missed)) {
return [check__quantity_text($bound(self, "value"), $bound(self, "dimension")), check__quantity_text($bound(self, "limit"), $bound(self, "dimension"))];
}
return [check__quantity_text($bound(self, "value"), $bound(self, "dimension"), $bound(self, "limit")), check__quantity_text($bound(self, "limit"), $bound(self, "dimension"), $bound(self, "value"))];
}
bound() {
const self = this; 
if ($truth($math.isnan($bound(self, "limit")))) {
return "";
}
return ("" + $str(($truth(self.at_most) ? "at most" : "at least")) + " " + $str($at(self.texts(), 1)));
}
get said() {
const self = this; let bound, limit, value, words;

([value, limit] = self.texts());
if (!$truth(self.says)) {
(bound = ($truth(limit) ? ("" + ", " + $str(self.bound())) : ""));
return ($truth(value) ? ("" + $str(self.title) + ": " + $str(value) + $str(bound) + ".") : ("" + $str(self.title) + "."));
}
(words = $map([...(function* () { for (const [n, [v, d]] of $iter($m.items(self.more))) { yield [n, check__quantity_text(v, d)]; } })()]));
(words = $merged(words, $map([["value", value], ["limit", limit]])));
return $m.join(" ", (function* () { for (const part of $iter([self.says, self.remedy])) { if (!($truth(part))) continue; yield $m.format(part, [], $map([...words])); } })());
}
get numerical() {
const self = this; 
return ($in(self.name, $c715));
}
get advises() {
const self = this; 
return $or(($in(self.name, $c716)), () => $and(($eq(self.name, "design_standard")), () => !$truth(self.binding)));
}
get leads() {
const self = this; 
return $and((self.level === "FAILS"), () => ($in(self.name, $c717)));
}
}
class Miss extends $Object {
$init(level, short, says, remedy, fails_beyond = NaN, because = "", tolerates = NaN, allows = "", otherwise = "") { this.level = level; this.short = short; this.says = says; this.remedy = remedy; this.fails_beyond = fails_beyond; this.because = because; this.tolerates = tolerates; this.allows = allows; this.otherwise = otherwise;  }
*[Symbol.iterator]() { yield this.level; yield this.short; yield this.says; yield this.remedy; yield this.fails_beyond; yield this.because; yield this.tolerates; yield this.allows; yield this.otherwise; }
at(value, at_most) {
const self = this; let says;

if ($truth(numbers__beyond(value, $bound(self, "fails_beyond"), at_most))) {
return ["FAILS", $m.rstrip(("" + $str(self.says) + " " + $str(self.because)))];
}
(says = ((value <= self.tolerates) ? ("" + $str(self.says) + " " + $str(self.allows)) : self.says));
return [self.level, $m.rstrip(says)];
}
}
class Motors extends $Object {
$init(motors) { this.motors = motors;  }
}
class Motor extends $Object {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$eq(self.count, $b.int($bound(self, "count"))))) {
(message = "must be a whole number of motors");
$m.append(problems, new Problem(message, undefined, undefined, "count", ("" + $format(self.count, ("" + "g")))));
}
limits__raise_all($add(problems, self._problems()));
}
_problems() {
const self = this; 
return [];
}
bears(momentary) {
const self = this; 
return ($truth(momentary) ? $b.min(1.6, self.largest_load()) : 1.0);
}
load(drum_torque) {
const self = this; let eta;

(eta = ((drum_torque >= 0.0) ? self.gear_efficiency : (1.0 / self.gear_efficiency)));
return (drum_torque / $mul(eta, self.drum_torque));
}
get drum_torque() {
const self = this; 
return $mul($mul(self.count, self.gear_ratio), self.rated_torque);
}
get rated_torque() {
const self = this; 
return (self.rated_power / self.rated_speed);
}
}
class Pulls extends $Object {
$init(effective_tensions) { this.effective_tensions = effective_tensions;  }
}
class Speeds extends $Object {
$init(rotation_speeds, absolute = false) { this.rotation_speeds = rotation_speeds; this.absolute = absolute;  }
}
class Owner extends $Object {
$init(of, words, place = $c87) { this.of = of; this.words = words; this.place = place;  }
*[Symbol.iterator]() { yield this.of; yield this.words; yield this.place; }
}
class Sliding extends $Object {
$init(place, cause) { this.place = place; this.cause = cause;  }
*[Symbol.iterator]() { yield this.place; yield this.cause; }
}
class Asked extends $Object {
$init(rule, wrap_factor, source, why_not = "") { this.rule = rule; this.wrap_factor = wrap_factor; this.source = source; this.why_not = why_not;  }
}
class Figure extends $Object {
$init(name, title, tension, place, binding = true, at_least = true) { this.name = name; this.title = title; this.tension = tension; this.place = place; this.binding = binding; this.at_least = at_least;  }
}
class LeastTension extends $Object {
$init(figures, given, counterweight) { this.figures = figures; this.given = given; this.counterweight = counterweight;  }
get governing() { return $kept(this, "governing", this.$find_governing()); }
get highest() { return $kept(this, "highest", this.$find_highest()); }
$find_governing() {
const self = this; 
return alike__largest((function* () { for (const f of $iter(self.figures)) { if (!(($truth(f.binding) && $truth(f.at_least)))) continue; yield f; } })(), least_tension___tension);
}
get tension() {
const self = this; let top;

(top = self.highest);
if (((top != null) && (top.tension < $mul(self.governing.tension, $sub(1.0, 1e-09))))) {
return Infinity;
}
return self.governing.tension;
}
get level() {
const self = this; 
return ((self.tension <= self.given) ? "OK" : "ATTENTION");
}
get raise_to() {
const self = this; 
return (((self.tension <= self.given) || $truth($math.isinf($bound(self, "tension")))) ? null : self.tension);
}
$find_highest() {
const self = this; let above;

(above = [...(function* () { for (const f of $iter(self.figures)) { if (!(!$truth(f.at_least))) continue; yield f; } })()]);
return ($truth(above) ? alike__least(above, least_tension___tension) : null);
}
get standard() {
const self = this; 
return $b.next((function* () { for (const f of $iter(self.figures)) { if (!(($eq(f.name, "design_standard")))) continue; yield f; } })(), null);
}
}
class Verdict extends $Object {
$init(checks, wet = -1.0, over_wet = false) { this.checks = checks; this.wet = wet; this.over_wet = over_wet;  }
get governing() { return $kept(this, "governing", this.$find_governing()); }
get listed() { return $kept(this, "listed", this.$find_listed()); }
get missed() { return $kept(this, "missed", this.$find_missed()); }
get _at() { return $kept(this, "_at", this.$find__at()); }
get _places() { return $kept(this, "_places", this.$find__places()); }
get odd() { return $kept(this, "odd", this.$find_odd()); }
get qualifier() { return $kept(this, "qualifier", this.$find_qualifier()); }
$find_governing() {
const self = this; let judged;

(judged = [...(function* () { for (const c of $iter(self.checks)) { if (!((c.level !== "NOT CHECKED"))) continue; yield c; } })()]);
return $b.min(judged, $k({key: check___badness, default: null}));
}
get level() {
const self = this; 
return ((self.governing == null) ? "OK" : self.governing.level);
}
get word() {
const self = this; let ok;

if ((self.level !== "OK")) {
return $b.str($bound(self, "level"));
}
(ok = ((self.wet < 0.0) ? $b.str("OK") : ("" + $str("OK") + " dry only")));
return ($truth(self.qualifier) ? ("" + $str(ok) + ", " + $str(self.qualifier)) : ok);
}
$find_listed() {
const self = this; let check, held, worst;

(worst = $map([]));
for (check of $iter(self.checks)) {
(held = $m.get(worst, $bound(check, "name"), check));
$put(worst, check.name, $b.min(held, check, $k({key: check___badness})));
}
return $b.tuple($m.values(worst));
}
$find_missed() {
const self = this; 
return $b.tuple($b.sorted((function* () { for (const c of $iter(self.listed)) { if (!($truth(c.missed))) continue; yield c; } })(), $k({key: check___badness})));
}
nearness(check) {
const self = this; 
return check___badness(check);
}
get data() {
const self = this; let told;

(told = (function* () { for (const c of $iter(self.checks)) { if (!((($eq(c.name, "data")) && $truth(c.says)))) continue; yield c.said; } })());
return $b.tuple($b.fromkeys(told));
}
at(pulley, load_case) {
const self = this; let known, mine, own, places, there;

(known = $m.setdefault(self._at, load_case, $map([])));
if ((!$in(pulley, known))) {
(places = $b.fromkeys(["", load_case]));
(there = $b.sorted((function* () { for (const place of $iter(places)) { for (const n of $iter($m.get(self._places, place, []))) { yield n; }} })()));
(mine = [...(function* () { for (const number of $iter(there)) { yield $at(self.checks, number); } })()]);
(own = $b.tuple((function* () { for (const check of $iter(mine)) { if (!(($in(check.place.pulley, ["", pulley])))) continue; yield check; } })()));
$put(known, pulley, (($eq($b.len(own), $b.len($bound(self, "checks")))) ? self : new Verdict(own)));
}
return $at(known, pulley);
}
$find__at() {
const self = this; return $map([]);
}
$find__places() {
const self = this; let check, found, number;
(found = $map([]));
for ([number, check] of $iter($b.enumerate($bound(self, "checks")))) {
$m.append($m.setdefault(found, $bound(check.place, "load_case"), []), number);
}
return found;
}
get lead() {
const self = this; let _, odd, said, text, value, where, worst;

(worst = self.governing);
if ((worst == null)) {
return "Nothing could be checked.";
}
if ((self.odd != null)) {
([said, odd] = (function* () { for (const check of $iter([worst, self.odd])) { yield $replaced(check, new Map([["remedy", ""]])); } })());
return $m.rstrip(("" + $str(check__placed(said)) + $str(self._sense()) + " " + $str(odd.said) + " " + $str(self.action)));
}
if ($truth(worst.missed)) {
return ("" + $str(check__placed(worst)) + $str(self._sense()));
}
(text = self._kept($b.sum((function* () { for (const c of $iter(self.listed)) { yield c.compares; } })())));
if (($truth($math.isnan($bound(worst, "margin"))) || $truth($math.isinf($bound(worst, "margin"))))) {
return ("" + $str(text) + "." + $str(self._sense()));
}
([value, _] = worst.texts());
(where = ($truth($b.str($bound(worst, "place"))) ? ("" + " (" + $str(worst.place) + ")") : ""));
return ("" + $str(text) + "; nearest to its limit is " + $str(check___small($bound(worst, "title"))) + ", " + $str(value) + ", " + $str(worst.bound()) + $str(where) + "." + $str(self._sense()));
}
get action() {
const self = this; let told;

(told = (function* () { for (const check of $iter([self.odd, self.governing])) { if (!(((check != null) && $truth(check.missed) && $truth(check.says)))) continue; yield $m.strip($m.removeprefix(check.said, $bound($replaced(check, new Map([["remedy", ""]])), "said"))); } })());
return $m.join(" ", $b.filter(null, told));
}
_sense() {
const self = this; let braking, every, here, some, title, told;

(every = $sub(new Set((function* () { for (const c of $iter(self.checks)) { yield c.place.load_case; } })()), new Set([""])));
(braking = [...(function* () { for (const c of $iter(self.checks)) { if (!(($eq(c.name, "sense")))) continue; yield c; } })()]);
(told = "");
for (title of $iter($b.fromkeys((function* () { for (const c of $iter(braking)) { yield c.title; } })()))) {
(here = new Set((function* () { for (const c of $iter(braking)) { if (!(($eq(c.title, title)))) continue; yield c.place.load_case; } })()));
(some = (($b.len(here) < $b.len(every)) ? ("" + " in " + $str($b.len(here)) + " of " + $str($b.len(every)) + " load cases") : ""));
(told = $add(told, ("" + " " + $str(title) + $str(some) + ".")));
}
return told;
}
_kept(count) {
const self = this; let known, told;

if ($truth(self.over_wet)) {
return ("" + $str(self.beyond_wet()) + ": all " + $str(count) + " checks are kept dry only");
}
(told = ("" + "All " + $str(count) + " checks are kept"));
if ((self.wet < 0.0)) {
return told;
}
(known = !$truth($math.isnan($bound(self, "wet"))));
return ("" + $str(told) + ", dry only" + $str(($truth(known) ? ("" + " (" + $str(self._when_wet()) + ")") : "")));
}
_when_wet() {
const self = this; let digits;
if ($truth($math.isinf($bound(self, "wet")))) {
return "wet it slips through";
}
(digits = $add(3, self.over_wet));
return ("" + "wet it creeps " + $str(cell__quantity($bound(self, "wet"), "length", digits)));
}
beyond_wet() {
const self = this; let limit;

if (!$truth(self.over_wet)) {
return "";
}
(limit = ($truth($math.isfinite($bound(self, "wet"))) ? ", beyond its limit" : ""));
return ("" + $str(check___capital(self._when_wet())) + $str(limit));
}
get others() {
const self = this; let first, others, told;

(first = new Set((function* () { for (const c of $iter([self.governing, self.odd])) { if (!((c != null))) continue; yield c.name; } })()));
(others = (function* () { for (const check of $iter(self.missed)) { if (!((!$in(check.name, first)))) continue; yield check; } })());
(told = [...(function* () { for (const check of $iter(others)) { yield ("" + $str(check.level) + ": " + $str(check__placed(check))); } })()]);
if ((($told($c85, self.level, "rank") > $told($c85, "OK", "rank")) && $truth(self.qualifier))) {
$m.append(told, ("" + "All of this stands " + $str(self.qualifier) + "."));
}
return $b.tuple(told);
}
$find_odd() {
const self = this; let worst;

(worst = self.governing);
if (((worst == null) || ($eq(worst.name, "usual_sizes")))) {
return null;
}
return $b.next((function* () { for (const c of $iter(self.listed)) { if (!((($eq(c.name, "usual_sizes")) && $truth(c.missed)))) continue; yield c; } })(), null);
}
$find_qualifier() {
const self = this; let found;

(found = new Set((function* () { for (const c of $iter(self.checks)) { if (!(($eq(c.name, "data")))) continue; yield c.short; } })()));
return $b.next((function* () { for (const word of $iter($c718)) { if (!(($in(word, found)))) continue; yield word; } })(), "");
}
}
class Row extends $Object {
$init(title, values, symbol = "", note = "", name = "", level = null) { this.title = title; this.values = values; this.symbol = symbol; this.note = note; this.name = name; this.level = level;  }
}
class Table extends $Object {
$init(title, rows, heads = $c88, note = "", name = "", short = null, brief = "") { this.title = title; this.rows = rows; this.heads = heads; this.note = note; this.name = name; this.short = short; this.brief = brief;  }
}
class TestedRange extends $Object {
$init(pressure_min, pressure_max, slip_max, slip_speed = null) { this.pressure_min = pressure_min; this.pressure_max = pressure_max; this.slip_max = slip_max; this.slip_speed = slip_speed; this.__post_init__?.(); }
__post_init__() {
const self = this; base__check([(0.0 < self.pressure_min && self.pressure_min <= self.pressure_max && self.pressure_max < Infinity), "pressure", ("" + $format(self.pressure_min, ("" + "g")) + " .. " + $format(self.pressure_max, ("" + "g")) + " Pa"), "the tested pressures must be positive, finite and in order"], [(0.0 < self.slip_max && self.slip_max < Infinity), "slip_max", ("" + $format(self.slip_max, ("" + "g")) + " m"), "the largest tested slip must be positive and finite"], [$or((self.slip_speed == null), () => (0.0 < self.slip_speed && self.slip_speed < Infinity)), "slip_speed", ("" + $str(self.slip_speed) + " m/s"), "the speed of slip in the tests must be positive and finite"]);
}
}
class FrictionLaw extends $Object {
$init(slip_includes = null) { this.slip_includes = slip_includes;  }
scaled(friction = 1.0, slip = 1.0) {
const self = this; 
return (($eq(friction, slip) && $eq(slip, 1.0)) ? self : self._scaled(friction, slip));
}
}
class MeasuredTable extends FrictionLaw {
$init(slip_includes = null, slip, pressure, values) { this.slip_includes = slip_includes; this.slip = slip; this.pressure = pressure; this.values = values; this.__post_init__?.(); }
__post_init__() {
const self = this; let m, numbers;
(m = $b.len($bound(self, "slip")));
(numbers = [...$iter(self.slip), ...$iter(self.pressure), ...$iter((function* () { for (const row of $iter(self.values)) { for (const v of $iter(row)) { yield v; }} })())]);
base__check([$b.all($b.map($math.isfinite, numbers)), "values", "", "the table must hold finite numbers only"], [$and((m >= 2), () => ($eq($at(self.slip, 0), 0.0))), "slip", ("" + $str(m) + " slips"), "at least two slips, the first of them 0, are needed"], [table___ascending($bound(self, "slip")), "slip", "", "the slips must be in ascending order"], [$or($b.all((function* () { for (const [a, b] of $iter($b.pairwise($bound(self, "slip")))) { yield ($sub(b, a) >= 1e-09); } })()), () => !$truth(table___ascending($bound(self, "slip")))), "slip", "", "the slips must be at least 1 nm apart"], [!$truth($b.any((function* () { for (const slip of $iter(self.slip)) { yield (1000.0 < slip && slip < Infinity); } })())), "slip", ("" + $format($b.max($bound(self, "slip"), $k({default: 0.0})), ("" + "g")) + " m"), "the slips must be at most 1 km"], [$and($b.bool($bound(self, "pressure")), () => $and(table___ascending($bound(self, "pressure")), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (p > 0); } })()))), "pressure", "", "the pressures must be positive and in ascending order"], [$and(($eq($b.len($bound(self, "values")), $b.len($bound(self, "pressure")))), () => $b.all((function* () { for (const row of $iter(self.values)) { yield ($eq($b.len(row), m)); } })())), "friction", "", ("" + "the table must have a row of " + $str(m) + " values for each of " + $str($b.len($bound(self, "pressure"))) + " pressures")], [$and($b.all((function* () { for (const row of $iter(self.values)) { for (const v of $iter($slice(row, null, 1))) { yield $or(($eq(v, 0.0)), () => (v >= 1e-06)); }} })()), () => $b.all((function* () { for (const row of $iter(self.values)) { for (const v of $iter($slice(row, 1, null))) { yield (v >= 1e-06); }} })())), "friction", "", ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " past slip 0, that or 0 at slip 0")], [($b.len(new Set((function* () { for (const row of $iter(self.values)) { if (!($truth(row))) continue; yield ($at(row, 0) > 0); } })())) <= 1), "friction", "", "friction at slip 0 must be 0 at every pressure or positive at every pressure"]);
}
get tested() {
const self = this; 
return new TestedRange($at(self.pressure, 0), $at(self.pressure, $neg(1)), $at(self.slip, $neg(1)));
}


_scaled(friction, slip) {
const self = this; let rows;
(rows = $b.tuple((function* () { for (const row of $iter(self.values)) { yield $b.tuple((function* () { for (const mu of $iter(row)) { yield $mul(mu, friction); } })()); } })()));
return $replaced(self, new Map([["slip", $b.tuple((function* () { for (const x of $iter(self.slip)) { yield $mul(x, slip); } })())], ["values", rows]]));
}
}
class _Term extends $Object {
$init(coefficient, function_, power, exponent) { this.coefficient = coefficient; this.function = function_; this.power = power; this.exponent = exponent;  }
*[Symbol.iterator]() { yield this.coefficient; yield this.function; yield this.power; yield this.exponent; }
}
class Trend extends $Object {
$init(form = "polynomial", coefficients, sign = 1) { this.form = form; this.coefficients = coefficients; this.sign = sign; this.__post_init__?.(); }
__post_init__() {
const self = this; let n;
(n = $b.len($bound(self, "coefficients")));
base__check([($in(self.form, $c719)), "form", self.form, ("" + "the form must be one of " + $str($m.join(", ", $c719)))], [(1 <= n && n <= 4), "coefficients", $b.str(n), "one to four coefficients are needed"], [$b.all($b.map($math.isfinite, $bound(self, "coefficients"))), "coefficients", $b.str($bound(self, "coefficients")), "must be finite"], [($in(self.sign, [1, $neg(1)])), "sign", $b.str($bound(self, "sign")), "the sign must be 1 or -1"]);
}
at(pressure) {
const self = this; let c, exponential, logarithmic, v, y;

([logarithmic, exponential] = $at($c719, self.form));
([v, y] = [($truth(logarithmic) ? $math.log(pressure) : pressure), 0.0]);
for (c of $iter($b.reversed($bound(self, "coefficients")))) {
(y = $add(c, $mul(y, v)));
}
return ($truth(exponential) ? $mul(self.sign, trend___exp(y)) : y);
}
times(factor) {
const self = this; let c;

(c = self.coefficients);
if (($in(self.form, ["power", "exponential"]))) {
return $replaced(self, new Map([["coefficients", [$add($at(c, 0), $math.log(factor)), ...$iter($slice(c, 1, null))]]]));
}
return $replaced(self, new Map([["coefficients", $b.tuple((function* () { for (const v of $iter(c)) { yield $mul(v, factor); } })())]]));
}
row() {
const self = this; let c, exponential, logarithmic;

([logarithmic, exponential] = $at($c719, self.form));
(c = $add(self.coefficients, $mul([0.0], $sub(4, $b.len($bound(self, "coefficients"))))));
return [...$iter(c), $b.float(logarithmic), ($truth(exponential) ? $b.float($bound(self, "sign")) : 0.0)];
}
}
class Piece extends $Object {
$init(a, b, post_peak_slope = $c89, residual_friction = $c90) { this.a = a; this.b = b; this.post_peak_slope = post_peak_slope; this.residual_friction = residual_friction;  }
}
class CoefficientPieces extends $Object {
$init(pressure, pieces, slip_unit = 1.0, continuity = 0.02) { this.pressure = pressure; this.pieces = pieces; this.slip_unit = slip_unit; this.continuity = continuity; this.__post_init__?.(); }
__post_init__() {
const self = this; let n, problems;
(n = $b.len($bound(self, "pieces")));
base__check([(n >= 1), "pieces", $b.str(n), "at least one piece is needed"], [($eq($b.len($bound(self, "pressure")), $add(n, 1))), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), ("" + "must have " + $str($add(n, 1)) + " pressures, the ends of " + $str(n) + " pieces")], [(0.0 < self.slip_unit && self.slip_unit < Infinity), "slip_unit", ("" + $format(self.slip_unit, ("" + "g")) + " m"), "the unit of slip must be positive and finite"], [$and($b.all((function* () { for (const [a, b] of $iter($b.zip($bound(self, "pressure"), $slice(self.pressure, 1, null), $k({strict: false})))) { yield (a < b); } })()), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (0 < p && p < Infinity); } })())), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), "the transition pressures must be positive, finite and in ascending order"]);
(problems = $or([...(function* () { for (const i of $iter($b.range(n))) { for (const p of $iter(self._piece_problems(i))) { yield p; }} })()], () => self._jumps()));
if ($truth(problems)) {
throw new InputError(problems);
}
}
_piece_problems(i) {
const self = this; let a, b, bad, high, key, low, piece, places, residual, slope, where, worst;
([low, high] = $slice(self.pressure, i, $add(i, 2)));
(places = [...(function* () { for (const k of $iter($b.range(101))) { yield $add(low, ($mul($sub(high, low), k) / 100.0)); } })()]);
(piece = $at(self.pieces, i));
(where = ("" + "between " + $format(low, ("" + "g")) + " and " + $format(high, ("" + "g")) + " Pa"));
(key = ("" + "pieces[" + $str($add(i, 1)) + "]"));
([a, b] = [[...(function* () { for (const p of $iter(places)) { yield piece.a.at(p); } })()], [...(function* () { for (const p of $iter(places)) { yield piece.b.at(p); } })()]]);
(slope = [...(function* () { for (const p of $iter(places)) { yield piece.post_peak_slope.at(p); } })()]);
(residual = [...(function* () { for (const p of $iter(places)) { yield piece.residual_friction.at(p); } })()]);
(bad = []);
if (!$truth($b.all((function* () { for (const v of $iter(a)) { yield $and($math.isfinite(v), () => (v < 0.0)); } })()))) {
(worst = $b.max([...(function* () { for (const v of $iter(a)) { if (!(($eq(v, v)))) continue; yield v; } })()], $k({default: NaN})));
$m.append(bad, new Problem(("" + "A must be negative " + $str(where) + ", else the law gives no positive friction"), undefined, undefined, ("" + $str(key) + ".a"), ("" + $format(worst, ("" + "g")) + " 1/m")));
} else {
if (!$truth($b.all((function* () { for (const [u, v] of $iter($b.zip(a, b, $k({strict: true})))) { yield $and((-700.0 <= $sub((v / u), 1.0) && $sub((v / u), 1.0) < 709.0), () => (1e-09 <= $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) && $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) <= 1000.0)); } })()))) {
$m.append(bad, new Problem(("" + "the slip at the peak exp(b/A - 1) must be 1 nm to 1 km " + $str(where)), undefined, undefined, ("" + $str(key) + ".b"), ("" + $format($at(b, 0), ("" + "g")) + " 1/m")));
}
}
if (!$truth($b.all((function* () { for (const v of $iter(slope)) { yield (v <= 0.0); } })()))) {
$m.append(bad, new Problem(("" + "the slope past the peak must be 0 or negative " + $str(where)), undefined, undefined, ("" + $str(key) + ".post_peak_slope"), ("" + $format($b.max(slope), ("" + "g")) + " 1/m")));
}
if (!$truth($b.all((function* () { for (const v of $iter(residual)) { yield (v >= 1e-06); } })()))) {
$m.append(bad, new Problem(("" + "residual friction must be at least " + $format(1e-06, ("" + "g")) + " " + $str(where)), undefined, undefined, ("" + $str(key) + ".residual_friction"), ("" + $format($b.min(residual), ("" + "g")))));
}
return bad;
}
_jumps() {
const self = this; let bad, high, i, low, name, p, u, v;
(bad = []);
for (i of $iter($b.range($sub($b.len($bound(self, "pieces")), 1)))) {
(p = $at(self.pressure, $add(i, 1)));
([low, high] = (function* () { for (const s of $iter($slice(self.pieces, i, $add(i, 2)))) { yield coefficients__peak_from_ab(s.a.at(p), s.b.at(p)); } })());
for ([name, u, v] of $iter([["peak friction", $at(low, 0), $at(high, 0)], ["peak slip", $at(low, 1), $at(high, 1)]])) {
if (($b.abs($sub((v / u), 1.0)) > self.continuity)) {
$m.append(bad, new Problem(("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %"), undefined, undefined, ("" + "pieces[" + $str($add(i, 2)) + "]"), ("" + $format(u, ("" + "g")) + " and " + $format(v, ("" + "g")))));
}
}
(bad = $add(bad, self._tail_jumps(i, p, low, high)));
}
return bad;
}
_tail_jumps(i, p, low, high) {
const self = this; let _, apart, friction, levels, lower, piece, slopes;

([levels, slopes] = [[], []]);
for ([piece, [friction, _]] of $iter($b.zip($slice(self.pieces, i, $add(i, 2)), [low, high], $k({strict: true})))) {
$m.append(levels, $b.min(piece.residual_friction.at(p), friction));
$m.append(slopes, (($at(levels, $neg(1)) < friction) ? piece.post_peak_slope.at(p) : 0.0));
}
(apart = ($mul($mul($b.abs($sub($at(slopes, 1), $at(slopes, 0))), self.slip_unit), $at(low, 1)) / $at(low, 0)));
(lower = ($truth($b.all(slopes)) ? ($mul($at(levels, 1), $at(low, 0)) / $mul($at(levels, 0), $at(high, 0))) : 1.0));
return [...(function* () { for (const [name, key, pair, unit, of, jump] of $iter([["the slope past the peak", "post_peak_slope", slopes, " 1/m", " of the peak friction over a peak slip", apart], ["residual friction", "residual_friction", levels, "", "", $b.abs($sub(lower, 1.0))]])) { if (!((jump > self.continuity))) continue; yield new Problem(("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %" + $str(of)), undefined, undefined, ("" + "pieces[" + $str($add(i, 2)) + "]." + $str(key)), ("" + $format($at(pair, 0), ("" + "g")) + " and " + $format($at(pair, 1), ("" + "g")) + $str(unit))); } })()];
}

scaled(friction, slip) {
const self = this; 
return $replaced(self, new Map([["slip_unit", $mul(self.slip_unit, slip)], ["pieces", $b.tuple((function* () { for (const piece of $iter(self.pieces)) { yield $replaced(piece, new Map([["a", piece.a.times(friction)], ["b", piece.b.times(friction)], ["post_peak_slope", piece.post_peak_slope.times((friction / slip))], ["residual_friction", piece.residual_friction.times(friction)]])); } })())]]));
}
}
class PressureKnots extends $Object {
$init(pressure, peak_friction, peak_slip, post_peak_slope = [], residual_friction = []) { this.pressure = pressure; this.peak_friction = peak_friction; this.peak_slip = peak_slip; this.post_peak_slope = post_peak_slope; this.residual_friction = residual_friction; this.__post_init__?.(); }
__post_init__() {
const self = this; let n;
(n = $b.len($bound(self, "pressure")));
base__check([(n >= 1), "pressure", $b.str(n), "at least one knot is needed"], ...$iter((function* () { for (const [name, values, optional] of $iter(self._columns())) { yield [$or(($eq($b.len(values), n)), () => $and(optional, () => !$truth(values))), name, ("" + $str($b.len(values)) + " values"), ("" + "must have " + $str(n) + " values, one for each pressure")]; } })()), ...$iter((function* () { for (const [name, values, _] of $iter(self._columns())) { yield [$b.all($b.map($math.isfinite, values)), name, $b.str(values), "must be finite numbers"]; } })()), [$and($b.all((function* () { for (const [a, b] of $iter($b.zip($bound(self, "pressure"), $slice(self.pressure, 1, null), $k({strict: false})))) { yield (a < b); } })()), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (p > 0); } })())), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), "the pressures of the knots must be positive and in ascending order"], [$b.all((function* () { for (const v of $iter(self.peak_friction)) { yield (v >= 1e-06); } })()), "peak_friction", coefficients___list($bound(self, "peak_friction")), ("" + "friction must be at least " + $format(1e-06, ("" + "g")))], [$b.all((function* () { for (const v of $iter(self.peak_slip)) { yield (1e-09 <= v && v <= 1000.0); } })()), "peak_slip", coefficients___list($bound(self, "peak_slip"), "m"), "slip at the peak must be 1 nm to 1 km"], [$b.all((function* () { for (const v of $iter(self.post_peak_slope)) { yield (v <= 0); } })()), "post_peak_slope", coefficients___list($bound(self, "post_peak_slope"), "1/m"), "the slope past the peak must be 0 or negative"], [$b.all((function* () { for (const v of $iter(self.residual_friction)) { yield (v >= 1e-06); } })()), "residual_friction", coefficients___list($bound(self, "residual_friction")), ("" + "residual friction must be at least " + $format(1e-06, ("" + "g")))]);
}
_columns() {
const self = this; return [["pressure", self.pressure, false], ["peak_friction", self.peak_friction, false], ["peak_slip", self.peak_slip, false], ["post_peak_slope", self.post_peak_slope, true], ["residual_friction", self.residual_friction, true]];
}
scaled(friction, slip) {
const self = this; 
return $replaced(self, new Map([["peak_friction", $b.tuple((function* () { for (const v of $iter(self.peak_friction)) { yield $mul(v, friction); } })())], ["peak_slip", $b.tuple((function* () { for (const v of $iter(self.peak_slip)) { yield $mul(v, slip); } })())], ["post_peak_slope", $b.tuple((function* () { for (const v of $iter(self.post_peak_slope)) { yield ($mul(v, friction) / slip); } })())], ["residual_friction", $b.tuple((function* () { for (const v of $iter(self.residual_friction)) { yield $mul(v, friction); } })())]]));
}

}
class IntegralLog extends FrictionLaw {
$init(slip_includes = null, coefficients, tested = null) { this.slip_includes = slip_includes; this.coefficients = coefficients; this.tested = tested; this.__post_init__?.(); }
__post_init__() {
const self = this; let p, t;
if (((self.tested == null) || ($b.len($bound(self.coefficients, "pressure")) < 2))) {
return null;
}
(p = self.coefficients.pressure);
(t = self.tested);
base__check([$and(($b.abs($sub((t.pressure_min / $at(p, 0)), 1.0)) < 1e-06), () => ($b.abs($sub((t.pressure_max / $at(p, $neg(1))), 1.0)) < 1e-06)), "tested", ("" + $format(t.pressure_min, ("" + "g")) + " .. " + $format(t.pressure_max, ("" + "g")) + " Pa"), ("" + "the tested pressures must be the ends of the law, " + $format($at(p, 0), ("" + "g")) + " .. " + $format($at(p, $neg(1)), ("" + "g")) + " Pa")]);
}



_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["coefficients", self.coefficients.scaled(friction, slip)]]));
}

}
class Factors extends $Object {
$init(law, by_slip_speed = null, by_temperature = null, slip_speed = null, temperature = null) { this.law = law; this.by_slip_speed = by_slip_speed; this.by_temperature = by_temperature; this.slip_speed = slip_speed; this.temperature = temperature; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all([...$iter(factors___outside("slip_speed", $bound(self, "slip_speed"), $bound(self, "by_slip_speed"), "speed")), ...$iter(factors___outside("temperature", $bound(self, "temperature"), $bound(self, "by_temperature"), "temperature"))]);
}
get used() {
const self = this; let fastest, law, tested;

(law = self.law.scaled($mul(self.of_slip_speed, self.of_temperature)));
([tested, fastest] = [law.tested, self.fastest]);
if (((tested == null) || (fastest == null) || $truth($b.isinstance(law, MeasuredTable)))) {
return law;
}
return $replaced(law, new Map([["tested", $replaced(tested, new Map([["slip_speed", fastest]]))]]));
}
get sources() {
const self = this; let tables;

(tables = $map([["slip_speed_factor", self.by_slip_speed], ["temperature_factor", self.by_temperature]]));
return $map([...(function* () { for (const [key, table] of $iter($m.items(tables))) { if (!((table != null))) continue; yield [key, table.source]; } })()]);
}
get fastest() {
const self = this; let table;

(table = self.by_slip_speed);
return ((table == null) ? null : $or(self.slip_speed, () => $at(table.at, $neg(1))));
}
get of_slip_speed() {
const self = this; let fastest, table;

([table, fastest] = [self.by_slip_speed, self.fastest]);
return (((table == null) || (fastest == null)) ? 1.0 : table.least($at(table.at, 0), fastest));
}
get of_temperature() {
const self = this; let table;

(table = self.by_temperature);
if ((table == null)) {
return 1.0;
}
if ((self.temperature != null)) {
return table.least($bound(self, "temperature"), $bound(self, "temperature"));
}
return $b.min($bound(table, "factor"));
}
}
class Lagging extends Viewable {
$init(name, law, thickness = 0.0, shear_modulus = Infinity, compression_modulus = Infinity, title = "", condition = "dry", surface = "", elastic_modulus = null, wear_coefficient = null, belt_energy_share = null, bond_strength = null, fatigue_limit = null, cost = null, fit = null, factors = null, condition_factors = new Map(), block = null, provenance = new Provenance(), sources = new Map(), notes = [], description = "") { this.name = name; this.law = law; this.thickness = thickness; this.shear_modulus = shear_modulus; this.compression_modulus = compression_modulus; this.title = title; this.condition = condition; this.surface = surface; this.elastic_modulus = elastic_modulus; this.wear_coefficient = wear_coefficient; this.belt_energy_share = belt_energy_share; this.bond_strength = bond_strength; this.fatigue_limit = fatigue_limit; this.cost = cost; this.fit = fit; this.factors = factors; this.condition_factors = condition_factors; this.block = block; this.provenance = provenance; this.sources = sources; this.notes = notes; this.description = description; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__name_problems("condition", $bound(self, "condition"))));
(problems = $add(problems, limits__limit_problems(self, $bound(self, "LIMITS"))));
if (($truth(self.surface) && (!$in(self.surface, $c720)))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c720))));
$m.append(problems, new Problem(message, undefined, undefined, "surface", $shown($bound(self, "surface"))));
}
limits__raise_all(problems);
}
get shear_compliance() {
const self = this; 
if (($in("lagging shear", $or(self.law.slip_includes, () => [])))) {
return 0.0;
}
return (self.thickness / self.shear_modulus);
}
source_of(part) {
const self = this; 
return $m.get(self.sources, part, $bound(self, "provenance"));
}
}
class LoadGiven extends $Object {
$init(entry_tension = null, exit_tension = null, effective_tension = null, torque = null, power = null) { this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.effective_tension = effective_tension; this.torque = torque; this.power = power;  }
*[Symbol.iterator]() { yield this.entry_tension; yield this.exit_tension; yield this.effective_tension; yield this.torque; yield this.power; }
}
class DrumAt extends $Object {
$init(diameter, speed) { this.diameter = diameter; this.speed = speed;  }
*[Symbol.iterator]() { yield this.diameter; yield this.speed; }
}
class Shares extends $Object {
$init(fractions) { this.fractions = fractions;  }
}
class Pair extends $Object {
$init(entry, exit) { this.entry = entry; this.exit = exit;  }
*[Symbol.iterator]() { yield this.entry; yield this.exit; }
}
class TorqueFollower extends $Object {
$init(master, ratio = 1.0) { this.master = master; this.ratio = ratio; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
class TrainCase extends $Object {
$init(name, entry_tension, exit_tension, division, runs = [], kind = "running", condition = "") { this.name = name; this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.division = division; this.runs = runs; this.kind = kind; this.condition = condition; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all($add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
}
get effective_tension() {
const self = this; 
return $add($sub(self.entry_tension, self.exit_tension), $b.sum($bound(self, "runs")));
}
get pulls_given() {
const self = this; 
return $b.isinstance(self.division, Shares, Pulls);
}
run(index) {
const self = this; 
return ((index < $b.len($bound(self, "runs"))) ? $at(self.runs, index) : 0.0);
}
}
class RunsGain extends $Object {
$init(base = 0.0, case_ = 0.0) { this.base = base; this.case = case_;  }
*[Symbol.iterator]() { yield this.base; yield this.case; }
}
class BehindTakeUp extends $Object {
$init(share, behind, runs) { this.share = share; this.behind = behind; this.runs = runs;  }
*[Symbol.iterator]() { yield this.share; yield this.behind; yield this.runs; }
}
class OfBelt extends $Dict {
}
class Description extends $Object {
$init(entry_tension, exit_tension, diameter, wrap_angle, width, axial_stiffness, thickness, shear_modulus, compression_modulus, overrun, recovery, belt_speed, wear_coefficient, shear_compliance, pitch_offset, centrifugal) { this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.diameter = diameter; this.wrap_angle = wrap_angle; this.width = width; this.axial_stiffness = axial_stiffness; this.thickness = thickness; this.shear_modulus = shear_modulus; this.compression_modulus = compression_modulus; this.overrun = overrun; this.recovery = recovery; this.belt_speed = belt_speed; this.wear_coefficient = wear_coefficient; this.shear_compliance = shear_compliance; this.pitch_offset = pitch_offset; this.centrifugal = centrifugal;  }
*[Symbol.iterator]() { yield this.entry_tension; yield this.exit_tension; yield this.diameter; yield this.wrap_angle; yield this.width; yield this.axial_stiffness; yield this.thickness; yield this.shear_modulus; yield this.compression_modulus; yield this.overrun; yield this.recovery; yield this.belt_speed; yield this.wear_coefficient; yield this.shear_compliance; yield this.pitch_offset; yield this.centrifugal; }
}
class TakeUp extends $Object {
$init(kind = "", sheave_ratio = 2.0, after = "") { this.kind = kind; this.sheave_ratio = sheave_ratio; this.after = after; this.__post_init__?.(); }
__post_init__() {
const self = this; let given, message, problems, remedy;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, criteria__choice_problems(self, $map([["kind", ["", ...$iter($c721)]]]))));
if (($truth(self.after) && $truth(self.fixed))) {
(message = "a fixed take-up holds the sum of both tensions wherever it stands");
(remedy = "Leave it out, or correct the kind.");
(given = $shown($bound(self, "after")));
$m.append(problems, new Problem(message, remedy, undefined, "after", given));
}
limits__raise_all(problems);
}
place_problems(pulleys) {
const self = this; let given, message, remedy;

if ((!$truth(self.after) || ($in(self.after, pulleys)))) {
return [];
}
(message = ("" + "no such pulley; the pulleys are " + $str($m.join(", ", $b.map($shown, pulleys)))));
(remedy = $or(errors__nearest($bound(self, "after"), pulleys), () => "Leave it out for a take-up on the slack side of the drives or at the tail."));
(given = $shown($bound(self, "after")));
return [new Problem(message, remedy, undefined, "take_up.after", given)];
}
get fixed() {
const self = this; 
return ($eq(self.kind, "fixed"));
}
counterweight(tension) {
const self = this; 
return ($mul(self.sheave_ratio, tension) / 9.80665);
}
}
class DesignStandard extends $Object {
$init(name = "", condition = "", friction = null, start_factor = 1.0, binding = false) { this.name = name; this.condition = condition; this.friction = friction; this.start_factor = start_factor; this.binding = binding; this.__post_init__?.(); }
__post_init__() {
const self = this; let given, message, problems, remedy, words;
(words = $map([["name", ["", ...$iter($c722)]], ["condition", ["", ...$iter($c723)]]]));
(problems = $add(limits__limit_problems(self, $bound(self, "LIMITS")), criteria__choice_problems(self, words)));
if ((!$eq(($eq(self.name, "own")), (self.friction != null)))) {
(given = ((self.friction == null) ? "" : ("" + $format(self.friction, ("" + "g")))));
(message = "missing, where the standard is your own");
(remedy = "Write friction = 0.30 beside it.");
if ($truth(given)) {
([message, remedy] = ["only a standard of your own has one", "Write name = \"own\"."]);
}
$m.append(problems, new Problem(message, remedy, undefined, "friction", given));
}
if ((($eq(self.name, "none")) && $truth(self.binding))) {
(message = "no standard was chosen that could bind");
$m.append(problems, new Problem(message, undefined, undefined, "binding", "true"));
}
limits__raise_all(problems);
}
}
class SafetyFactors extends $Object {
$init(running = 1.25, starting = 1.1, braking = 1.1, source = "") { this.running = running; this.starting = starting; this.braking = braking; this.source = source; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
of(kind) {
const self = this; 
return $b.float($b.getattr(self, kind));
}
}
class Kind extends $Object {
built(value, report, more = new Map()) {
const self = this; 
return value;
}
}
class tables$Table extends Kind {
get _fields() { return $kept(this, "_fields", this.$find__fields()); }
$init(title, of = null, on_one_line = false, ...entries) {
const self = this; ([self.title, self.of, self.on_one_line] = [title, of, on_one_line]);
(self.entries = $b.tuple((function* () { for (const e of $iter(entries)) { yield ((e.kind === $c724) ? $replaced(e, new Map([["kind", tables___kind_of(of, $bound(e, "attribute"))]])) : e); } })()));
(self._known = $map([...(function* () { for (const entry of $iter(self.entries)) { yield [entry.key, entry]; } })()]));
}
read(raw, place, report) {
const self = this; let entry, given, key, known, record, remedy, value;

if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", "Write its keys below its name in [ ].", raw);
return $c7;
}
(given = self._renamed(raw, place, report));
(known = self._known);
for (key of $iter([...(function* () { for (const key of $iter(given)) { if (!((!$in(key, known)))) continue; yield key; } })()])) {
(remedy = ($truth(report.full) ? "" : tables__unknown_key_remedy(key, known)));
report.add([...$iter(place), key], "unknown key", remedy, $at(given, key));
}
(record = new Record($map([]), place, given));
for ([key, entry] of $iter($m.items(known))) {
if (($in(key, given))) {
(value = entry.kind.read($at(given, key), [...$iter(place), key], report));
if (!$truth(tables___sound(value))) {
record.faulty.add(key);
}
if ((value !== $c7)) {
$put(record, key, value);
}
} else {
if (($truth(entry.required) && !($truth(entry.unless) && ($in(entry.unless, given))))) {
record.faulty.add(key);
report.add([...$iter(place), key], "missing", tables__missing_remedy(entry));
}
}
}
return record;
}
built(value, report, more = new Map()) {
const self = this; let made, names, record, values;

if ((!$truth($b.isinstance(value, Record)) || !$truth(value.sound()) || (self.of == null))) {
return null;
}
([made, record] = [self.of, value]);
(values = $map([...(function* () { for (const e of $iter(self.entries)) { if (!((($in(e.key, record)) && ($in(e.attribute, self._fields)) && !$truth($b.isinstance($at(record, e.key), "dict"))))) continue; yield [e.attribute, tables___frozen($at(record, e.key))]; } })()]));
(names = $map([...(function* () { for (const e of $iter(self.entries)) { yield [e.attribute, e.key]; } })()]));
return report.tried((() => $call(made, [], [...$map([...values, ...more])])), $bound(record, "place"), $bound(record, "raw"), names);
}
_renamed(raw, place, report) {
const self = this; let entry, given, message, value;
(given = $b.dict(raw));
for (entry of $iter(self.entries)) {
if ((!$truth(entry.alias) || (!$in(entry.alias, given)))) {
continue;
}
(value = $m.pop(given, $bound(entry, "alias")));
if (($in(entry.key, given))) {
(message = ("" + "means the same as " + $str(entry.key) + ", which is also there"));
report.add([...$iter(place), entry.alias], message, "Keep one of them.", value);
} else {
$put(given, entry.key, value);
}
}
return given;
}
$find__fields() {
const self = this; 
return ($truth(self.of) ? $b.frozenset((function* () { for (const f of $iter($fields(self.of))) { yield f.name; } })()) : $b.frozenset());
}
}
class Entry extends $Object {
$init(key, meaning = "", kind = $c724, title = "", required = false, alias = "", example = "", attribute = "", unless = "", stated = false) { this.key = key; this.meaning = meaning; this.kind = kind; this.title = title; this.required = required; this.alias = alias; this.example = example; this.attribute = attribute; this.unless = unless; this.stated = stated; this.__post_init__?.(); }
__post_init__() {
const self = this; (self.title = $or(self.title, () => $m.capitalize($m.replace(self.key, "_", " "))));
(self.attribute = $or(self.attribute, () => self.key));
}
}
class Name extends Kind {
$init(longest = 60) { this.longest = longest;  }
read(raw, place, report) {
const self = this; let value;

(value = new Text($bound(self, "longest")).read(raw, place, report));
if (((value !== $c7) && !$truth($m.strip(value)))) {
report.add(place, "must not be empty", "Write a name.", raw);
return $c7;
}
return value;
}
}
class Text extends Kind {
$init(longest = 200, lines = false) { this.longest = longest; this.lines = lines;  }
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "str"))) {
report.add(place, "must be text", "Put it in quotes.", raw);
} else {
if (($b.len(raw) > self.longest)) {
report.add(place, ("" + "longer than " + $str(self.longest) + " characters"), "Shorten it.", raw);
} else {
if (!$truth($m.isprintable(($truth(self.lines) ? $m.translate(raw, $c725) : raw)))) {
report.add(place, "holds characters that cannot be printed", "Remove them.", raw);
} else {
return raw;
}
}
}
return $c7;
}
}
class Quantity extends Kind {
$init(dimension, limit = null) { this.dimension = dimension; this.limit = limit;  }
read(raw, place, report) {
const self = this; let error, refusal, value;

try {
(value = parse__parse_quantity(raw, $bound(self, "dimension")));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
report.take(error, place, raw);
return $c7;
} else throw $error;
}
(refusal = ($truth(self.limit) ? self.limit.refusal(value) : ""));
if ($truth(refusal)) {
$method(report, "add", [place, refusal], [["value", raw]]);
return $c7;
}
return value;
}
}
class Limit extends $Object {
$init(dimension, least = 0.0, most = Infinity, open = false, rigid = false) { this.dimension = dimension; this.least = least; this.most = most; this.open = open; this.rigid = rigid;  }
__str__() {
const self = this; let least;

(least = self._shown($bound(self, "least")));
if (($eq(self.most, Infinity))) {
return ($truth(self.open) ? ("" + "more than " + $str(least)) : ("" + "at least " + $str(least)));
}
if (($eq(self.least, $neg(Infinity)))) {
return ("" + "at most " + $str(self._shown($bound(self, "most"))));
}
if ($truth(self.open)) {
return ("" + "more than " + $str(least) + " and at most " + $str(self._shown($bound(self, "most"))));
}
return ("" + "between " + $str(least) + " and " + $str(self._shown($bound(self, "most"))));
}
_shown(bound) {
const self = this; return display__display(bound, $bound(self, "dimension"), undefined, 3);
}
refusal(value) {
const self = this; let unit;

if (!$truth(isNumber(value))) {
(unit = $at($c12, self.dimension).si_unit);
return ($truth(unit) ? ("" + "must be a number [" + $str(unit) + "]") : "must be a number");
}
if (($truth($math.isnan(value)) || ($truth($math.isinf(value)) && !($truth(self.rigid) && (value > 0))))) {
return "must be finite";
}
if ((!(self.least <= value && value <= self.most) || ($truth(self.open) && ($eq(value, self.least))))) {
return ("" + "must be " + $str(self));
}
return "";
}
}
class WordOr extends Kind {
$init(word, kind, meaning = null) { this.word = word; this.kind = kind; this.meaning = meaning;  }
read(raw, place, report) {
const self = this; 
return (($eq(raw, self.word)) ? self.meaning : self.kind.read(raw, place, report));
}
}
class ByName extends Kind {
$init(kind, most = 200) { this.kind = kind; this.most = most;  }
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", ("" + "Write [" + $str($at(place, $neg(1))) + ".NAME]."), raw);
return $c7;
}
if (($b.len(raw) > self.most)) {
report.add(place, ("" + "must have at most " + $str(self.most) + " entries, and has " + $str($b.len(raw))));
return $c7;
}
return $map([...(function* () { for (const [name, item] of $iter($m.items(raw))) { if (!((new Name().read(name, [...$iter(place), name], report) !== $c7))) continue; yield [name, self.kind.read(item, [...$iter(place), name], report)]; } })()]);
}
}
class Belt extends $Object {
$init(name, width, modulus, rating = null, strength = null, speed = null, kind = "", momentary_factor = null, least_pulley_diameter = null, largest_wrap_pressure = null, in_plane_shear_stiffness = null, pulley_cover = null, carry_cover = null, carcass = null, thickness = null, cover_shear_modulus = null, mass = null, provenance = new Provenance(), sources = new Map()) { this.name = name; this.width = width; this.modulus = modulus; this.rating = rating; this.strength = strength; this.speed = speed; this.kind = kind; this.momentary_factor = momentary_factor; this.least_pulley_diameter = least_pulley_diameter; this.largest_wrap_pressure = largest_wrap_pressure; this.in_plane_shear_stiffness = in_plane_shear_stiffness; this.pulley_cover = pulley_cover; this.carry_cover = carry_cover; this.carcass = carcass; this.thickness = thickness; this.cover_shear_modulus = cover_shear_modulus; this.mass = mass; this.provenance = provenance; this.sources = sources; this.__post_init__?.(); }
__post_init__() {
const self = this; let problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
limits__raise_all($or(problems, () => self._layer_problems()));
}
_layer_problems() {
const self = this; let given, key, message, remedy, rounding, short, total, whole;

(given = $map([...(function* () { for (const key of $iter($c6)) { if (!(($b.getattr(self, key) != null))) continue; yield [key, $b.getattr(self, key)]; } })()]));
([total, whole] = [$b.sum($m.values(given)), self.thickness]);
([short, key, remedy] = [(total <= 0.06), "thickness", ""]);
if ((whole == null)) {
(key = $b.next($b.iter(given), "thickness"));
(message = ("" + "more than " + $str(display__display(0.06, "length")) + ", the thickest belt"));
(remedy = "Check their units.");
} else {
(rounding = $mul(1e-09, whole));
(short = (total <= $add(whole, ((self.carcass != null) ? rounding : $neg(rounding)))));
(message = ("" + "too much for a belt of " + $str(display__display(whole, "length"))));
(remedy = "Give the thickness of the whole belt, or leave it out.");
if ((($eq($b.len(given), $b.len($c6))) && (total < $mul(0.98, whole)))) {
([short, message] = [false, ("" + "and the belt is " + $str(display__display(whole, "length")) + " thick")]);
(remedy = "Leave out the one of the four that is not known.");
}
}
if ($truth(short)) {
return [];
}
(message = ("" + $str($m.join(" + ", given)) + " = " + $str(display__display(total, "length")) + ", " + $str(message)));
return [new Problem(message, remedy, undefined, key)];
}
source_of(part) {
const self = this; 
return $m.get(self.sources, part, $bound(self, "provenance"));
}
get breaking_strength() {
const self = this; let found;

(found = $m.search($c726, $m.upper(self.name)));
return (($truth(found) && (self.strength == null)) ? $mul(1000.0, $b.float($at(found, 1))) : self.strength);
}
get axial_stiffness() {
const self = this; 
return $mul(self.modulus, self.width);
}
}
class _Nothing extends $Object {
}
class TextOr extends Kind {
$init(text, table) { this.text = text; this.table = table;  }
read(raw, place, report) {
const self = this; 
return ($truth($b.isinstance(raw, "dict")) ? self.table : self.text).read(raw, place, report);
}
}
class Flag extends Kind {
$init() {   }
read(raw, place, report) {
const self = this; 
if ($truth($b.isinstance(raw, "bool"))) {
return raw;
}
report.add(place, "must be true or false", "Write it without quotes.", raw);
return $c7;
}
}
class Choice extends Kind {
$init(options) { this.options = options;  }
read(raw, place, report) {
const self = this; let allowed;

if (($truth($b.isinstance(raw, "str")) && ($in(raw, self.options)))) {
return raw;
}
(allowed = $m.join(", ", (function* () { for (const option of $iter(self.options)) { yield $shown(option); } })()));
report.add(place, ("" + "must be one of " + $str(allowed)), errors__nearest(raw, $bound(self, "options")), raw);
return $c7;
}
}
class Across extends $Object {
$init(shell_profile = null, worn_depth = null, build_up = null, misalignment = 0.0, deflection = 0.0, entry_profile = null, before = null, after = null, strips = 32) { this.shell_profile = shell_profile; this.worn_depth = worn_depth; this.build_up = build_up; this.misalignment = misalignment; this.deflection = deflection; this.entry_profile = entry_profile; this.before = before; this.after = after; this.strips = strips; this.__post_init__?.(); }
__post_init__() {
const self = this; let key, least, message, problems, profile;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if (!(4 <= self.strips && self.strips <= 128)) {
(message = ("" + "must be a whole number from " + $str(4) + " to " + $str(128)));
$m.append(problems, new Problem(message, undefined, undefined, "strips", $b.str($bound(self, "strips"))));
}
for (key of $iter(["worn_depth", "build_up"])) {
(profile = $b.getattr(self, key));
if (((profile != null) && ($b.min([...$iter(profile.value), profile.crown]) < 0.0))) {
(least = display__display($b.min([...$iter(profile.value), profile.crown]), "length"));
(message = "must not be negative");
$m.append(problems, new Problem(message, undefined, undefined, key, least));
}
}
limits__raise_all(problems);
}
problems(key, width) {
const self = this; let found;

(found = [...(function* () { for (const [name, profile] of $iter($m.items(self.profiles()))) { for (const problem of $iter(profile.problems(("" + $str(key) + "." + $str(name)), width))) { yield problem; }} })()]);
if (($truth($b.isinstance(self.before, Transition)) && (self.before.centre_roll >= width))) {
$m.append(found, new Problem(("" + "wider than the belt, " + $str(display__display(width, "length"))), "Give the width of belt on the centre roll.", undefined, ("" + $str(key) + ".before.centre_roll"), display__display($bound(self.before, "centre_roll"), "length")));
}
return found;
}
profiles() {
const self = this; let found;

(found = $map([...(function* () { for (const f of $iter($fields(self))) { yield [f.name, $b.getattr(self, $bound(f, "name"))]; } })()]));
return $map([...(function* () { for (const [k, v] of $iter($m.items(found))) { if (!($truth($b.isinstance(v, WidthProfile)))) continue; yield [k, v]; } })()]);
}
}
class DimensionText extends $Object {
$init(si_unit, name, example) { this.si_unit = si_unit; this.name = name; this.example = example;  }
*[Symbol.iterator]() { yield this.si_unit; yield this.name; yield this.example; }
}
class Definition extends $Object {
$init(names, factor, unit, zero = $c733) { this.names = names; this.factor = factor; this.unit = unit; this.zero = zero;  }
*[Symbol.iterator]() { yield this.names; yield this.factor; yield this.unit; yield this.zero; }
}
class Variant extends Kind {
$init(tag, meaning, ...tables) {
const self = this; (self.tag = tag);
(self.tables = $map([...(function* () { for (const t of $iter(tables)) { yield [t.title, $call(tables$Table, [$bound(t, "title"), tables__need(tag, meaning, new Choice([t.title])), ...$iter(t.entries)], [["of", t.of]])]; } })()]));
}
built(value, report, more = new Map()) {
const self = this; 
if ((!$truth($b.isinstance(value, Record)) || !$truth(value.sound()))) {
return null;
}
return $method($at(self.tables, $at(value, self.tag)), "built", [value, report], [...more]);
}
read(raw, place, report) {
const self = this; let allowed, options, word;

if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", "Write its keys below its name in [ ].", raw);
return $c7;
}
(options = $b.tuple($bound(self, "tables")));
if ((!$in(self.tag, raw))) {
(allowed = $m.join(", ", (function* () { for (const option of $iter(options)) { yield $shown(option); } })()));
report.add([...$iter(place), self.tag], "missing", ("" + "Write one of " + $str(allowed) + "."));
return $c7;
}
(word = new Choice(options).read($at(raw, self.tag), [...$iter(place), self.tag], report));
return ((word === $c7) ? $c7 : $at(self.tables, word).read(raw, place, report));
}
}
class Pulley extends $Object {
$init(name, diameter, wrap_angle, lagging, overrun = null, recovery = true, creep_limit = null, side = "pulley", mass = null, across = null, sources = new Map(), conditions = []) { this.name = name; this.diameter = diameter; this.wrap_angle = wrap_angle; this.lagging = lagging; this.overrun = overrun; this.recovery = recovery; this.creep_limit = creep_limit; this.side = side; this.mass = mass; this.across = across; this.sources = sources; this.conditions = conditions; this.__post_init__?.(); }
__post_init__() {
const self = this; let problems, worn;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
(problems = $add(problems, criteria__choice_problems(self, $map([["side", $c727]]))));
(worn = ($truth(self.across) ? self.across.worn_depth : null));
if (((worn != null) && (worn.largest >= self.lagging.thickness))) {
$m.append(problems, new Problem($add("deeper than the lagging is thick, ", display__display($bound(self.lagging, "thickness"), "length")), "Give the depth worn off, on radius, not what is left.", undefined, "across.worn_depth", display__display($bound(worn, "largest"), "length")));
}
limits__raise_all(problems);
}
lagging_in(condition) {
const self = this; 
if (!$truth(condition)) {
return self.lagging;
}
try {
return $b.next((function* () { for (const lagging of $iter(self.conditions)) { if (!(($eq(lagging.condition, condition)))) continue; yield lagging; } })());
} catch ($error) {
if ($error instanceof $StopIteration) {
throw new $KeyError(condition);
} else throw $error;
}
}
in_condition(condition) {
const self = this; 
return ($truth(condition) ? $replaced(self, new Map([["lagging", self.lagging_in(condition)]])) : self);
}
get radius() {
const self = this; 
return (self.diameter / 2.0);
}
}
class Sag extends $Object {
$init(spacing, line_mass, share = 0.02) { this.spacing = spacing; this.line_mass = line_mass; this.share = share; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get tension() {
const self = this; 
return ($mul($mul(self.line_mass, 9.80665), self.spacing) / $mul(8.0, self.share));
}
}
class Conveyor extends $Object {
$init(length, lift = 0.0, belt_mass, carry_idler_mass, return_idler_mass, material_mass = null, capacity = null, friction_factor = 0.02, length_coefficient = null, secondary_resistance = null, special_resistance = 0.0, return_share = 0.0, start_factor = null, start_time = null, stop_time = null, take_up_tension = null, counterweight = null, take_up_distance = 0.0, drive_at = "head", speed = null, sheave_ratio = 2.0) { this.length = length; this.lift = lift; this.belt_mass = belt_mass; this.carry_idler_mass = carry_idler_mass; this.return_idler_mass = return_idler_mass; this.material_mass = material_mass; this.capacity = capacity; this.friction_factor = friction_factor; this.length_coefficient = length_coefficient; this.secondary_resistance = secondary_resistance; this.special_resistance = special_resistance; this.return_share = return_share; this.start_factor = start_factor; this.start_time = start_time; this.stop_time = stop_time; this.take_up_tension = take_up_tension; this.counterweight = counterweight; this.take_up_distance = take_up_distance; this.drive_at = drive_at; this.speed = speed; this.sheave_ratio = sheave_ratio; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, conveyor__choices(new Set((function* () { for (const key of $iter(self.LIMITS)) { if (!(($b.getattr(self, key) != null))) continue; yield key; } })()))));
if ((!$in(self.drive_at, $c728))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c728))));
$m.append(problems, new Problem(message, undefined, undefined, "drive_at", $shown($bound(self, "drive_at"))));
}
limits__raise_all($or(problems, () => $b.list(self.misfits())));
}
*misfits() {
const self = this; let given, long, message;

(long = display__display($bound(self, "length"), "length"));
if (($b.abs($bound(self, "lift")) >= self.length)) {
(given = display__display($bound(self, "lift"), "length"));
yield new Problem(("" + "must be less than the length, " + $str(long)), undefined, undefined, "lift", given);
}
if ((self.take_up_distance > self.length)) {
(given = display__display($bound(self, "take_up_distance"), "length"));
(message = ("" + "is more than the length, " + $str(long) + ", which is the tail"));
yield new Problem(message, undefined, undefined, "take_up_distance", given);
}
if (((self.secondary_resistance == null) && (self.length_coefficient == null))) {
yield* $iter(resistance__no_coefficient($bound(self, "length")));
}
}
get take_up() {
const self = this; 
if ((self.take_up_tension != null)) {
return self.take_up_tension;
}
return ($mul(conveyor___known($bound(self, "counterweight"), 0.0), 9.80665) / self.sheave_ratio);
}
get coefficient() {
const self = this; 
if ((self.secondary_resistance != null)) {
return null;
}
return conveyor___known($bound(self, "length_coefficient"), resistance__coefficient_at($bound(self, "length")));
}
states() {
const self = this; let states;

(states = self.reckoned());
limits__raise_all(self.unfit(states));
return $b.tuple(states);
}
reckoned() {
const self = this; let acceleration, full, kind, name, states;

(full = self._state("full", "running", $bound(self, "material"), 0.0));
(states = [full, self._state("empty", "running", 0.0, 0.0)]);
for ([name, kind, acceleration] of $iter(self._changes($bound(full, "pull")))) {
$m.append(states, self._state(name, kind, $bound(self, "material"), acceleration));
}
return states;
}
unfit(states) {
const self = this; let least, message, problems, remedy, state;

(problems = []);
if (((self.start_factor != null) && ($at(states, 0).pull <= 0.0))) {
(message = "the full conveyor runs by itself, and no factor starts it");
(remedy = "Write start_time = \"20 s\" instead.");
$m.append(problems, new Problem(message, remedy, undefined, "start_factor"));
}
for (state of $iter(states)) {
(least = $b.min($bound(state, "head"), $bound(state, "tail"), $bound(state, "entry"), $bound(state, "exit")));
if ((least <= 0.0)) {
$m.append(problems, conveyor___slack(state, least));
}
}
return problems;
}
*_changes(pull) {
const self = this; let moving;

if ((self.start_factor != null)) {
(moving = $add(self._moving($bound(self, "material")), self._moving(null)));
yield ["start", "starting", ($mul($sub(self.start_factor, 1.0), pull) / $mul(self.length, moving))];
}
if (((self.start_time != null) && (self.speed != null))) {
yield ["start", "starting", (self.speed / self.start_time)];
}
if (((self.stop_time != null) && (self.speed != null))) {
yield ["stop", "braking", ($neg(self.speed) / self.stop_time)];
}
}
_moving(material) {
const self = this; 
if ((material == null)) {
return $add(self.return_idler_mass, self.belt_mass);
}
return $add($add(self.carry_idler_mass, self.belt_mass), material);
}
_state(name, kind, material, acceleration) {
const self = this; let at_head, carrying, entry, head, leaving, resistances, returning, tail;
(resistances = $b.tuple(self._resistances(material, acceleration)));
(carrying = $b.sum((function* () { for (const r of $iter(resistances)) { yield r.carrying; } })()));
(returning = $b.sum((function* () { for (const r of $iter(resistances)) { yield r.returning; } })()));
(head = $sub(self.take_up, ($mul(returning, self.take_up_distance) / self.length)));
(tail = $add(head, returning));
(at_head = ($eq(self.drive_at, "head")));
(entry = ($truth(at_head) ? $add(tail, carrying) : tail));
(leaving = ($truth(at_head) ? head : $sub(head, carrying)));
return new State(name, kind, resistances, head, tail, entry, leaving);
}
*_resistances(material, acceleration) {
const self = this; let belt, carrying, coefficient, down, factor, length, lift, loaded, main, returning, secondary, share, source, special, up;
([belt, loaded, share] = [self.belt_mass, $add(self.belt_mass, material), self.return_share]);
([factor, length, lift] = [self.friction_factor, self.length, self.lift]);
(main = new Resistance("main", resistance__main_resistance(factor, length, lift, $bound(self, "carry_idler_mass"), loaded), resistance__main_resistance(factor, length, lift, $bound(self, "return_idler_mass"), belt), ("" + $str("DIN 22101:2002-08, 6.2; ISO 5048:1989: f L g (m'R + (m'G + m'L) cos delta)") + ", f = " + $format(self.friction_factor, ("" + "g")) + $str(self._unusual))));
yield main;
([secondary, source] = [self.secondary_resistance, "given"]);
if ((secondary == null)) {
(coefficient = conveyor___known($bound(self, "coefficient"), 1.0));
(secondary = $mul($sub(coefficient, 1.0), main.total));
(source = ("" + $str("DIN 22101:2002-08, 6.3.3: (C - 1) times the main resistance") + ", C = " + $format(coefficient, ("" + ".3g"))));
(source = $add(source, ((self.length_coefficient == null) ? "" : " (given)")));
}
yield new Resistance("secondary", $mul($sub(1.0, share), secondary), $mul(share, secondary), source);
([up, down] = [resistance__slope_resistance($bound(self, "lift"), loaded), $neg(resistance__slope_resistance($bound(self, "lift"), belt))]);
yield new Resistance("slope", up, down, "DIN 22101:2002-08, 6.4: g H (m'G + m'L), up on one strand and down on the other");
(special = self.special_resistance);
yield new Resistance("special", $mul($sub(1.0, share), special), $mul(share, special), "given");
(carrying = resistance__inertia(acceleration, $bound(self, "length"), self._moving(material)));
(returning = resistance__inertia(acceleration, $bound(self, "length"), self._moving(null)));
yield new Resistance("inertia", carrying, returning, "force to accelerate belt, material and rotating idlers (DIN 22101:2002-08, 7.3), the idlers with their whole rotating mass");
}
get material() {
const self = this; 
if ((self.material_mass != null)) {
return self.material_mass;
}
return (conveyor___known($bound(self, "capacity"), 0.0) / conveyor___known($bound(self, "speed"), 1.0));
}
get _unusual() {
const self = this; let least, most;
([least, most] = $c1402);
if ((least <= self.friction_factor && self.friction_factor <= most)) {
return "";
}
return ("" + ", outside the usual " + $format(least, ("" + ".3f")) + " to " + $format(most, ("" + ".3f")));
}
}
class Rule extends $Object {
$init(name, what, missed = "ATTENTION", at_most = true, fails_beyond = NaN, tolerates = NaN) { this.name = name; this.what = what; this.missed = missed; this.at_most = at_most; this.fails_beyond = fails_beyond; this.tolerates = tolerates;  }
}
class DesignFriction extends $Object {
$init(standard, surface, condition, friction, provenance) { this.standard = standard; this.surface = surface; this.condition = condition; this.friction = friction; this.provenance = provenance;  }
}
class Cost extends $Object {
$init(material, installation, currency, area, life_years) { this.material = material; this.installation = installation; this.currency = currency; this.area = area; this.life_years = life_years; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems, years;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(years = self.life_years);
if (!(0.0 < $at(years, 0) && $at(years, 0) <= $at(years, 1) && $at(years, 1) < Infinity)) {
(message = "must be the shortest and the longest life in years, both more than 0");
$m.append(problems, new Problem(message, undefined, undefined, "life_years", $shown($b.list(years))));
}
limits__raise_all(problems);
}
}
class Block extends $Object {
$init(shape = "square", width, height, stiffening = 0.54, contact_fraction = 1.0) { this.shape = shape; this.width = width; this.height = height; this.stiffening = stiffening; this.contact_fraction = contact_fraction; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.shape, $c730))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c730))));
$m.append(problems, new Problem(message, undefined, undefined, "shape", $shown($bound(self, "shape"))));
}
limits__raise_all(problems);
}
get shape_factor() {
const self = this; 
return compression__shape_factor(($eq(self.shape, "square")), $bound(self, "width"), $bound(self, "height"));
}
}
class ConditionFactor extends $Object {
$init(factor, source) { this.factor = factor; this.source = source; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
class FrictionFactor extends $Object {
$init(at, factor, source) { this.at = at; this.factor = factor; this.source = source; this.__post_init__?.(); }
__post_init__() {
const self = this; let bad, count, message, n, problems;
([n, problems] = [$b.len($bound(self, "at")), $b.list()]);
if (((n < 2) || (!$eq($b.len($bound(self, "factor")), n)))) {
(count = ("" + $str(n) + " values and " + $str($b.len($bound(self, "factor"))) + " factors"));
(message = "must be as many factors as values, two at least");
$m.append(problems, new Problem(message, undefined, undefined, "factor", count));
}
if ($truth($b.any((function* () { for (const [before, after] of $iter($b.pairwise($bound(self, "at")))) { yield (after <= before); } })()))) {
$m.append(problems, new Problem("must ascend", undefined, undefined, "at", $shown($b.list($bound(self, "at")))));
}
(bad = [...(function* () { for (const v of $iter(self.factor)) { if (!(!(0.0 < v && v <= 10.0))) continue; yield v; } })()]);
if ($truth(bad)) {
(message = "must be more than 0 and at most 10");
$m.append(problems, new Problem(message, undefined, undefined, "factor", $shown($at(bad, 0))));
}
limits__raise_all(problems);
}
least(low, high) {
const self = this; let inside;

(inside = [...(function* () { for (const [x, f] of $iter($b.zip($bound(self, "at"), $bound(self, "factor"), $k({strict: true})))) { if (!((low <= x && x <= high))) continue; yield f; } })()]);
return $b.min([...$iter(inside), self._of(low), self._of(high)]);
}
_of(value) {
const self = this; let f, f1, rows, x, x1;

(rows = $b.list($b.zip($bound(self, "at"), $bound(self, "factor"), $k({strict: true}))));
for ([[x, f], [x1, f1]] of $iter($b.pairwise(rows))) {
if ((x <= value && value < x1)) {
return $add($mul(($sub(f1, f) / $sub(x1, x)), $sub(value, x)), f);
}
}
return ((value < $at(self.at, 0)) ? $at(self.factor, 0) : $at(self.factor, $neg(1)));
}
}
class Fit extends $Object {
$init(parameters, values, covariance, residual_noise = null, date = "", method = "", misfit = [], misfit_accepted = "", coverage_factor = 1.96) { this.parameters = parameters; this.values = values; this.covariance = covariance; this.residual_noise = residual_noise; this.date = date; this.method = method; this.misfit = misfit; this.misfit_accepted = misfit_accepted; this.coverage_factor = coverage_factor; this.__post_init__?.(); }
get knots() { return $kept(this, "knots", this.$find_knots()); }
__post_init__() {
const self = this; let message, n, problems;
(n = $b.len($bound(self, "parameters")));
(problems = limits__limit_problems(self, $c731));
if ((($b.len($b.set($bound(self, "parameters"))) < n) || !$truth(n))) {
(message = "must name each fitted parameter once");
$m.append(problems, new Problem(message, undefined, undefined, "parameters", $b.str(n)));
}
if (((!$eq($b.len($bound(self, "values")), n)) || !$truth($b.all($b.map($math.isfinite, $bound(self, "values")))))) {
(message = ("" + "must be " + $str(n) + " finite numbers, one for each parameter"));
$m.append(problems, new Problem(message, undefined, undefined, "values", $b.str($b.len($bound(self, "values")))));
}
(problems = $add(problems, self._covariance_problems(n)));
limits__raise_all(problems);
}
_covariance_problems(n) {
const self = this; let apart, given, matrix, message, numbers, rows;
(rows = [...(function* () { for (const row of $iter(self.covariance)) { yield $b.len(row); } })()]);
if ((!$eq(rows, $mul([n], n)))) {
(given = ("" + $str($b.len(rows)) + " rows of " + $str($b.sorted($b.set(rows))) + " numbers"));
(message = ("" + "must be " + $str(n) + " rows of " + $str(n) + " numbers, one for each parameter"));
return [new Problem(message, undefined, undefined, "covariance", given)];
}
([matrix, message] = [self.covariance, ""]);
(numbers = [...(function* () { for (const row of $iter(matrix)) { for (const v of $iter(row)) { yield v; }} })()]);
(apart = [...(function* () { for (const i of $iter($b.range(n))) { for (const j of $iter($b.range(i))) { yield $b.abs($sub($at($at(matrix, i), j), $at($at(matrix, j), i))); }} })()]);
if (!$truth($b.all($b.map($math.isfinite, numbers)))) {
(message = "must be finite");
} else {
if (($b.max(apart, $k({default: 0.0})) > $mul(1e-09, $b.max($b.map($b.abs, numbers), $k({default: 0.0}))))) {
(message = "must be symmetric");
} else {
if (!$truth(fit___has_no_negative(matrix, $mul(1e-08, n)))) {
(message = "must have no negative eigenvalue: no variance is negative");
}
}
}
return ($truth(message) ? [new Problem(message, undefined, undefined, "covariance")] : []);
}
$find_knots() {
const self = this; let found, named;

(found = [...(function* () { for (const name of $iter(self.parameters)) { yield $m.fullmatch($c732, name); } })()]);
if (($b.min($bound(self, "values")) <= 0.0)) {
return [];
}
(named = $b.tuple((function* () { for (const match of $iter(found)) { if (!($truth(match))) continue; yield [$sub($b.int($at(match, 1)), 1), $at(match, 2)]; } })()));
return (($eq($b.len(named), $b.len(found))) ? named : []);
}
}
class VariableSpeed extends Motor {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, setting = 1.0, droop = 0.0, torque_limit = Infinity) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.setting = setting; this.droop = droop; this.torque_limit = torque_limit; this.__post_init__?.(); }
largest_load() {
const self = this; let stall;

(stall = ((self.droop > 0.0) ? ($mul(0.9, self.setting) / self.droop) : Infinity));
return $b.min($bound(self, "torque_limit"), stall);
}
shaft_speed(load) {
const self = this; 
return $mul(self.rated_speed, $b.max($sub(self.setting, $mul(self.droop, load)), 0.001));
}
}
class Induction extends Motor {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, synchronous_speed, breakdown_ratio = 2.5) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.synchronous_speed = synchronous_speed; this.breakdown_ratio = breakdown_ratio; this.__post_init__?.(); }
_problems() {
const self = this; let message;
if (($mul(0.8, self.synchronous_speed) <= self.rated_speed && self.rated_speed < self.synchronous_speed)) {
return [];
}
(message = ("" + "must be below the synchronous speed " + $str(motors___rpm($bound(self, "synchronous_speed"))) + " by at most 20 %"));
return [new Problem(message, undefined, undefined, "rated_speed", motors___rpm($bound(self, "rated_speed")))];
}
largest_load() {
const self = this; 
return self.breakdown_ratio;
}
bears(momentary) {
const self = this; 
return $b.min(super.bears(momentary), $mul(0.81, self.breakdown_ratio));
}
shaft_speed(load) {
const self = this; let breakdown_slip, part, ratio, x;

(ratio = self.breakdown_ratio);
(x = (load / ratio));
(part = (x / $add(1.0, $math.sqrt($b.max($sub(1.0, $mul(x, x)), 0.0)))));
(breakdown_slip = $mul(self.rated_slip, $add(ratio, $math.sqrt($sub($mul(ratio, ratio), 1.0)))));
return $mul(self.synchronous_speed, $b.max($sub(1.0, $mul(breakdown_slip, part)), 0.001));
}
get rated_slip() {
const self = this; 
return $sub(1.0, (self.rated_speed / self.synchronous_speed));
}
}
class FluidCoupling extends Induction {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, synchronous_speed, breakdown_ratio = 2.5, coupling_load, coupling_slip) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.synchronous_speed = synchronous_speed; this.breakdown_ratio = breakdown_ratio; this.coupling_load = coupling_load; this.coupling_slip = coupling_slip; this.__post_init__?.(); }
get _end() { return $kept(this, "_end", this.$find__end()); }
_problems() {
const self = this; let count, key, loads, message, problems, rising, slips, top, values;
(problems = super._problems());
([loads, slips] = [self.coupling_load, self.coupling_slip]);
if (((!$eq($b.len(loads), $b.len(slips))) || ($b.len(loads) < 2))) {
(count = ("" + $str($b.len(loads)) + " and " + $str($b.len(slips))));
(message = "the curve needs as many torques as slips, two or more of each");
$m.append(problems, new Problem(message, undefined, undefined, "coupling_slip", count));
}
for ([key, values, top] of $iter([["coupling_load", loads, 10.0], ["coupling_slip", slips, 0.9]])) {
(rising = $b.all((function* () { for (const [a, b] of $iter($b.pairwise(values))) { yield (a < b); } })()));
if (!($truth(values) && ($eq($at(values, 0), 0.0)) && $truth(rising) && ($at(values, $neg(1)) <= top))) {
(message = ("" + "must rise from 0 to at most " + $format(top, ("" + "g"))));
$m.append(problems, new Problem(message, undefined, undefined, key, $b.str($b.list(values))));
}
}
return problems;
}
largest_load() {
const self = this; 
return self._end;
}
$find__end() {
const self = this; let _, high, load, low, pump;

([low, high] = [0.0, self.breakdown_ratio]);
for (_ of $iter($b.range(60))) {
(load = $mul(0.5, $add(low, high)));
(pump = super.shaft_speed(load));
if (($mul(load, $pow((self.rated_speed / pump), 2)) <= $at(self.coupling_load, $neg(1)))) {
(low = load);
} else {
(high = load);
}
}
return (($eq(high, self.breakdown_ratio)) ? high : low);
}
shaft_speed(load) {
const self = this; let pump;

(pump = super.shaft_speed(load));
return $mul(pump, $sub(1.0, self._slip($mul(load, $pow((self.rated_speed / pump), 2)))));
}
_slip(load) {
const self = this; let i, loads, size, slip, slips, weight;
([size, loads, slips] = [$b.abs(load), self.coupling_load, self.coupling_slip]);
(i = 0);
while (((i < $sub($b.len(loads), 2)) && (size > $at(loads, $add(i, 1))))) {
(i = $add(i, 1));
}
(weight = ($sub(size, $at(loads, i)) / $sub($at(loads, $add(i, 1)), $at(loads, i))));
(slip = $add($at(slips, i), $mul(weight, $sub($at(slips, $add(i, 1)), $at(slips, i)))));
return $math.copysign($b.min(slip, 0.95), load);
}
}
class Load extends $Object {
$init(entry_tension, exit_tension, creep_limit, pressure_min, pressure_max, slip_max, steepest_fall) { this.entry_tension = entry_tension; this.exit_tension = exit_tension; this.creep_limit = creep_limit; this.pressure_min = pressure_min; this.pressure_max = pressure_max; this.slip_max = slip_max; this.steepest_fall = steepest_fall;  }
*[Symbol.iterator]() { yield this.entry_tension; yield this.exit_tension; yield this.creep_limit; yield this.pressure_min; yield this.pressure_max; yield this.slip_max; yield this.steepest_fall; }
}
class Transition extends $Object {
$init(length, trough_angle, centre_roll, depth = "full") { this.length = length; this.trough_angle = trough_angle; this.centre_roll = centre_roll; this.depth = depth; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.depth, $c1099))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c1099))));
$m.append(problems, new Problem(message, undefined, undefined, "depth", $shown($bound(self, "depth"))));
}
limits__raise_all(problems);
}
}
class State extends $Object {
$init(name, kind, resistances, head, tail, entry, exit) { this.name = name; this.kind = kind; this.resistances = resistances; this.head = head; this.tail = tail; this.entry = entry; this.exit = exit;  }
get pull() {
const self = this; 
return $b.sum((function* () { for (const resistance of $iter(self.resistances)) { yield resistance.total; } })());
}
}
class Resistance extends $Object {
$init(name, carrying, returning, source) { this.name = name; this.carrying = carrying; this.returning = returning; this.source = source;  }
get total() {
const self = this; 
return $add(self.carrying, self.returning);
}
}
class OneOrMore extends Kind {
$init(kind, most = 50) { this.kind = kind; this.most = most;  }
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "list"))) {
return [self.kind.read(raw, place, report)];
}
return new Rows($bound(self, "kind"), 1, $bound(self, "most")).read(raw, place, report);
}
}
class Rows extends Kind {
$init(kind, least = 0, most = 1000) { this.kind = kind; this.least = least; this.most = most;  }
read(raw, place, report) {
const self = this; let count, labels;

if (!$truth($b.isinstance(raw, "list"))) {
report.add(place, "must be an array", "Put it in [ ], as the examples show.", raw);
return $c7;
}
if (!(self.least <= $b.len(raw) && $b.len(raw) <= self.most)) {
(count = ($truth(self.least) ? ("" + $str(self.least) + " to " + $str(self.most)) : ("" + "at most " + $str(self.most))));
report.add(place, ("" + "must have " + $str(count) + " entries, and has " + $str($b.len(raw))));
return $c7;
}
(labels = kinds__table_labels(raw));
return [...(function* () { for (const [item, label] of $iter($b.zip(raw, labels, $k({strict: true})))) { yield self.kind.read(item, [...$iter(place), label], report); } })()];
}
}
class Constant extends FrictionLaw {
$init(slip_includes = null, friction_coefficient, tested = null) { this.slip_includes = slip_includes; this.friction_coefficient = friction_coefficient; this.tested = tested; this.__post_init__?.(); }
__post_init__() {
const self = this; let mu;
(mu = self.friction_coefficient);
base__check([(1e-06 <= mu && mu < Infinity), "friction_coefficient", ("" + $format(mu, ("" + "g"))), ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " and finite")]);
}

compact() {
const self = this; 
return new CompactLaw(0, simple___edges($bound(self, "tested")), [self.friction_coefficient, 1.0, 0.0, 0.0]);
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
class ElasticPlastic extends FrictionLaw {
$init(slip_includes = null, stiffness, friction_coefficient, tested = null) { this.slip_includes = slip_includes; this.stiffness = stiffness; this.friction_coefficient = friction_coefficient; this.tested = tested; this.__post_init__?.(); }
__post_init__() {
const self = this; let k, mu;
([mu, k] = [self.friction_coefficient, self.stiffness]);
base__check([(1e-06 <= mu && mu < Infinity), "friction_coefficient", ("" + $format(mu, ("" + "g"))), ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " and finite")], [(0.0 < k && k < Infinity), "stiffness", ("" + $format(k, ("" + "g")) + " Pa/m"), "the stiffness must be positive and finite"]);
}

compact() {
const self = this; let c;

(c = [self.friction_coefficient, 1.0, 0.0, (1.0 / self.stiffness)]);
return new CompactLaw(0, simple___edges($bound(self, "tested")), c, undefined, (1.0 / self.stiffness));
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["stiffness", ($mul(self.stiffness, friction) / slip)], ["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
class PressurePower extends FrictionLaw {
$init(slip_includes = null, friction_coefficient, reference_pressure, exponent, tested = null) { this.slip_includes = slip_includes; this.friction_coefficient = friction_coefficient; this.reference_pressure = reference_pressure; this.exponent = exponent; this.tested = tested; this.__post_init__?.(); }
__post_init__() {
const self = this; let mu, n, p;
([mu, p, n] = [self.friction_coefficient, self.reference_pressure, self.exponent]);
base__check([(1e-06 <= mu && mu < Infinity), "friction_coefficient", ("" + $format(mu, ("" + "g"))), ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " and finite")], [(0.0 < p && p < Infinity), "reference_pressure", ("" + $format(p, ("" + "g")) + " Pa"), "the pressure must be positive and finite"], [(0.0 <= n && n < 1.0), "exponent", ("" + $format(n, ("" + "g"))), "the exponent must lie in 0 <= n < 1"]);
}

compact() {
const self = this; let c;

(c = [self.friction_coefficient, self.reference_pressure, self.exponent, 0.0]);
return new CompactLaw(0, simple___edges($bound(self, "tested")), c);
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
class Profile extends Kind {
$init(dimension, diameters = false) {
const self = this; let entries, words;
([self.dimension, self.diameters] = [dimension, diameters]);
(self.rows = new Rows(new _Pair(dimension), 0, 500));
(entries = [new Entry("rows", "Pairs of position, 0 in the middle of the belt, and value.", $bound(self, "rows")), new Entry("crown", "Height of a parabola in the middle over the edges of the belt.", new Quantity(dimension)), new Entry("factor", "Factor on all values: how much of the profile there is.", new Quantity("number", new Limit("number", undefined, 100.0))), new Entry("uncertainty", "Standard uncertainty of the values.", new Quantity(dimension, new Limit(dimension)))]);
if ($truth(diameters)) {
(words = "Whether the values are on radius (if left out) or on diameter.");
$m.append(entries, new Entry("on", words, new Choice(["radius", "diameter"])));
}
(self.within = new TextOr($bound(self, "rows"), $call(tables$Table, ["Profile", ...$iter(entries)], [["on_one_line", true]])));
}
read(raw, place, report) {
const self = this; let built, crown, factor, found, half, heights, mean, on, read, rows, table, values;

(found = $b.len($bound(report, "problems")));
(read = self.within.read(raw, place, report));
if (((read === $c7) || ($b.len($bound(report, "problems")) > found))) {
return $c7;
}
(table = ($truth($b.isinstance(read, Record)) ? read : $map([["rows", read]])));
([rows, on] = [$m.get(table, "rows", []), $m.get(table, "on", "radius")]);
if ((!$truth(rows) && (!$in("crown", table)))) {
return null;
}
([half, factor] = [(($eq(on, "diameter")) ? 0.5 : 1.0), $m.get(table, "factor", 1.0)]);
(values = [...(function* () { for (const [_, value] of $iter(rows)) { yield $mul(half, value); } })()]);
if ((($eq(on, "diameter")) && $truth(values) && ($b.min(values) > 0.1))) {
(mean = ($b.sum(values) / $b.len(values)));
(values = [...(function* () { for (const value of $iter(values)) { yield $sub(value, mean); } })()]);
}
(crown = $mul($mul(factor, half), $m.get(table, "crown", 0.0)));
(values = [...(function* () { for (const value of $iter(values)) { yield $mul(factor, value); } })()]);
(heights = [...$iter(values), crown]);
if (($truth(self.diameters) && !$truth(self._deviations(heights, half, place, report)))) {
return $c7;
}
(built = report.tried((() => new WidthProfile($b.tuple((function* () { for (const [y, _] of $iter(rows)) { yield y; } })()), $b.tuple(values), crown, (($in("uncertainty", table)) ? $mul($mul(factor, half), $at(table, "uncertainty")) : null))), place));
return ((built == null) ? $c7 : built);
}
_deviations(values, half, place, report) {
const self = this; let worst;

(worst = $b.max(values, $k({key: $b.abs, default: 0.0})));
if (($b.abs(worst) <= 0.1)) {
return true;
}
report.add(place, ("" + "a deviation of the radius is expected, at most " + $str(display__display(0.1, "length"))), "Give deviations from the even radius; for those of the diameter, or diameters, write { rows = [...], on = \"diameter\" }.", quantity_text__quantity_text((worst / half), "length"));
return false;
}
}
class GrippingPulley extends $Object {
$init(distance) { this.distance = distance; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
class Count extends Kind {
$init(least, most) { this.least = least; this.most = most;  }
read(raw, place, report) {
const self = this; let message, whole;

(whole = $and($b.isinstance(raw, "int"), () => !$truth($b.isinstance(raw, "bool"))));
if (($truth(whole) && (self.least <= raw && raw <= self.most))) {
return raw;
}
(message = ("" + "must be a whole number from " + $str(self.least) + " to " + $str(self.most)));
$method(report, "add", [place, message], [["value", raw]]);
return $c7;
}
}
class Elsewhere extends Kind {
$init() {   }
read(raw, place, report) {
const self = this; 
return raw;
}
}
class Either extends Kind {
$init(first, second, words) { this.first = first; this.second = second; this.words = words;  }
read(raw, place, report) {
const self = this; let kind, value;

for (kind of $iter([self.first, self.second])) {
try {
parse__parse_quantity(raw, $bound(kind, "dimension"));
} catch ($error) {
if ($error instanceof InputError) {
continue;
} else throw $error;
}
(value = kind.read(raw, place, report));
return ((value === $c7) ? $c7 : [kind.dimension, value]);
}
$method(report, "add", [place, ("" + "must be " + $str(self.words))], [["value", raw]]);
return $c7;
}
}
class SpeedList extends Kind {
$init() {   }
read(raw, place, report) {
const self = this; 
if (($eq(raw, "equal"))) {
return "equal";
}
if ($truth($b.isinstance(raw, "str"))) {
$method(report, "add", [place, ("" + "must be \"" + $str("equal") + "\" or an array of speeds")], [["value", raw]]);
return $c7;
}
return self.rows.read(raw, place, report);
}
}
class _OfClass extends Kind {
read(raw, place, report) {
const self = this; 
throw $TypeError;
}
}
class CompactLaw extends $Object {
$init(kind, edges, coefficients, slips = [], onset_compliance = 0.0) { this.kind = kind; this.edges = edges; this.coefficients = coefficients; this.slips = slips; this.onset_compliance = onset_compliance;  }
*[Symbol.iterator]() { yield this.kind; yield this.edges; yield this.coefficients; yield this.slips; yield this.onset_compliance; }
}
class _Pair extends Kind {
$init(dimension) {
const self = this; (self.kinds = [new Quantity("length"), new Quantity(dimension)]);
}
read(raw, place, report) {
const self = this; let pair;
if ((!$truth($b.isinstance(raw, "list")) || (!$eq($b.len(raw), 2)))) {
$method(report, "add", [place, "must be a pair, position and value"], [["value", raw]]);
return $c7;
}
(pair = [...(function* () { for (const [kind, item, what] of $iter($b.zip($bound(self, "kinds"), raw, ["position", "value"], $k({strict: true})))) { yield kind.read(item, [...$iter(place), what], report); } })()]);
return (($in($c7, pair)) ? $c7 : $b.tuple(pair));
}
}
const $c744 = ["of", "entries", "_known"];
const $c759 = ["key", "kind", "required", "alias", "example", "attribute", "unless"];
const $c129 = ["dimension", "limit"];
const $c760 = $made(Quantity, $c129, ["number", null]);
const $c747 = $made(Entry, $c759, ["format", $c760, true, "", "format = 1", "format", ""]);
const $c762 = ["longest", "lines"];
const $c761 = $made(Text, $c762, [200, false]);
const $c748 = $made(Entry, $c759, ["title", $c761, false, "", "", "title", ""]);
const $c763 = $made(Text, $c762, [5000, true]);
const $c749 = $made(Entry, $c759, ["description", $c763, false, "", "", "description", ""]);
const $c765 = ["dimension", "least", "most", "open", "rigid"];
const $c695 = $made(Limit, $c765, ["length", 0.0, 1.0, true, false]);
const $c764 = $made(Quantity, $c129, ["length", $c695]);
const $c750 = $made(Entry, $c759, ["creep_limit", $c764, false, "", "", "creep_limit", ""]);
const $c767 = ["kind", "most"];
const $c768 = ["text", "table"];
const $c770 = ["longest"];
const $c769 = $made(Name, $c770, [60]);
const $c778 = $made(Name, $c770, [60]);
const $c773 = $made(Entry, $c759, ["name", $c778, true, "", "", "name", ""]);
const $c691 = $made(Limit, $c765, ["number", 0.0, 2.0, true, false]);
const $c779 = $made(Quantity, $c129, ["number", $c691]);
const $c774 = $made(Entry, $c759, ["friction_factor", $c779, false, "", "", "factor", ""]);
const $c780 = $made(ByName, $c767, [$c779, 200]);
const $c775 = $made(Entry, $c759, ["friction_factors", $c780, false, "", "", "friction_factors", ""]);
const $c782 = ["options"];
const $c783 = ["DIN 22101", "practice"];
const $c781 = $made(Choice, $c782, [$c783]);
const $c776 = $made(Entry, $c759, ["standard", $c781, false, "", "", "standard", ""]);
const $c791 = ["measured", "published", "calibrated", "illustrative", "given"];
const $c790 = $made(Choice, $c782, [$c791]);
const $c786 = $made(Entry, $c759, ["kind", $c790, true, "", "", "kind", ""]);
const $c792 = $made(Text, $c762, [500, false]);
const $c787 = $made(Entry, $c759, ["source", $c792, false, "", "", "source", ""]);
const $c793 = $made(Text, $c762, [60, false]);
const $c788 = $made(Entry, $c759, ["date", $c793, false, "", "", "date", ""]);
const $c794 = $made(Text, $c762, [1000, false]);
const $c789 = $made(Entry, $c759, ["note", $c794, false, "", "", "note", ""]);
const $c784 = [$c786, $c787, $c788, $c789];
const $c785 = new Map([["kind", $c786], ["source", $c787], ["date", $c788], ["note", $c789]]);
const $c2 = $made(tables$Table, $c744, [Provenance, $c784, $c785]);
const $c777 = $made(Entry, $c759, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c771 = [$c773, $c774, $c775, $c776, $c777];
const $c772 = new Map([["name", $c773], ["friction_factor", $c774], ["friction_factors", $c775], ["standard", $c776], ["provenance", $c777]]);
const $c8 = $made(tables$Table, $c744, [Condition, $c771, $c772]);
const $c190 = $made(TextOr, $c768, [$c769, $c8]);
const $c766 = $made(OneOrMore, $c767, [$c190, 8]);
const $c751 = $made(Entry, $c759, ["condition", $c766, false, "", "", "condition", ""]);
const $c125 = $made(Name, $c770, [60]);
const $c104 = $made(Entry, $c759, ["preset", $c125, false, "", "", "preset", ""]);
const $c126 = $made(Name, $c770, [60]);
const $c105 = $made(Entry, $c759, ["name", $c126, false, "", "", "name", ""]);
const $c127 = $made(Text, $c762, [60, false]);
const $c106 = $made(Entry, $c759, ["kind", $c127, false, "", "", "kind", ""]);
const $c130 = $made(Limit, $c765, ["length", 0.001, 1000.0, false, false]);
const $c128 = $made(Quantity, $c129, ["length", $c130]);
const $c107 = $made(Entry, $c759, ["width", $c128, true, "", "", "width", ""]);
const $c796 = ["word", "kind", "meaning"];
const $c135 = $made(Limit, $c765, ["force_per_width", 1000.0, Infinity, false, true]);
const $c134 = $made(Quantity, $c129, ["force_per_width", $c135]);
const $c132 = $made(WordOr, $c796, ["rigid", $c134, Infinity]);
const $c108 = $made(Entry, $c759, ["modulus", $c132, false, "", "", "modulus", ""]);
const $c137 = $made(Limit, $c765, ["force_per_width", 0.0, Infinity, true, false]);
const $c136 = $made(Quantity, $c129, ["force_per_width", $c137]);
const $c109 = $made(Entry, $c759, ["rating", $c136, false, "", "", "rating", ""]);
const $c139 = $made(Limit, $c765, ["force_per_width", 0.0, Infinity, true, false]);
const $c138 = $made(Quantity, $c129, ["force_per_width", $c139]);
const $c110 = $made(Entry, $c759, ["strength", $c138, false, "", "", "strength", ""]);
const $c141 = $made(Limit, $c765, ["speed", 0.0, 1000.0, true, false]);
const $c140 = $made(Quantity, $c129, ["speed", $c141]);
const $c111 = $made(Entry, $c759, ["speed", $c140, false, "", "", "speed", ""]);
const $c143 = $made(Limit, $c765, ["number", 1.0, 10.0, false, false]);
const $c142 = $made(Quantity, $c129, ["number", $c143]);
const $c112 = $made(Entry, $c759, ["momentary_factor", $c142, false, "", "", "momentary_factor", ""]);
const $c145 = $made(Limit, $c765, ["length", 0.0, Infinity, true, false]);
const $c144 = $made(Quantity, $c129, ["length", $c145]);
const $c113 = $made(Entry, $c759, ["least_pulley_diameter", $c144, false, "", "", "least_pulley_diameter", ""]);
const $c147 = $made(Limit, $c765, ["pressure", 0.0, Infinity, true, false]);
const $c146 = $made(Quantity, $c129, ["pressure", $c147]);
const $c114 = $made(Entry, $c759, ["largest_wrap_pressure", $c146, false, "", "", "largest_wrap_pressure", ""]);
const $c149 = $made(Limit, $c765, ["force_per_width", 1.0, 1000000000.0, false, false]);
const $c148 = $made(Quantity, $c129, ["force_per_width", $c149]);
const $c115 = $made(Entry, $c759, ["in_plane_shear_stiffness", $c148, false, "", "", "in_plane_shear_stiffness", ""]);
const $c151 = $made(Limit, $c765, ["length", 0.0, 0.06, false, false]);
const $c150 = $made(Quantity, $c129, ["length", $c151]);
const $c116 = $made(Entry, $c759, ["pulley_cover", $c150, false, "", "", "pulley_cover", ""]);
const $c153 = $made(Limit, $c765, ["length", 0.0, 0.06, false, false]);
const $c152 = $made(Quantity, $c129, ["length", $c153]);
const $c117 = $made(Entry, $c759, ["carry_cover", $c152, false, "", "", "carry_cover", ""]);
const $c155 = $made(Limit, $c765, ["length", 0.0, 0.06, true, false]);
const $c154 = $made(Quantity, $c129, ["length", $c155]);
const $c118 = $made(Entry, $c759, ["carcass", $c154, false, "", "", "carcass", ""]);
const $c157 = $made(Limit, $c765, ["length", 0.0, 0.06, true, false]);
const $c156 = $made(Quantity, $c129, ["length", $c157]);
const $c119 = $made(Entry, $c759, ["thickness", $c156, false, "", "", "thickness", ""]);
const $c160 = $made(Limit, $c765, ["pressure", 100000.0, 100000000.0, false, true]);
const $c159 = $made(Quantity, $c129, ["pressure", $c160]);
const $c158 = $made(WordOr, $c796, ["rigid", $c159, Infinity]);
const $c120 = $made(Entry, $c759, ["cover_shear_modulus", $c158, false, "", "", "cover_shear_modulus", ""]);
const $c162 = $made(Limit, $c765, ["mass_per_length", 0.0, 1000000.0, true, false]);
const $c161 = $made(Quantity, $c129, ["mass_per_length", $c162]);
const $c121 = $made(Entry, $c759, ["mass", $c161, false, "", "", "mass", ""]);
const $c122 = $made(Entry, $c759, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c163 = $made(ByName, $c767, [$c2, 200]);
const $c123 = $made(Entry, $c759, ["sources", $c163, false, "", "", "sources", ""]);
const $c1 = [$c104, $c105, $c106, $c107, $c108, $c109, $c110, $c111, $c112, $c113, $c114, $c115, $c116, $c117, $c118, $c119, $c120, $c121, $c122, $c123];
const $c795 = new Map([["preset", $c104], ["name", $c105], ["kind", $c106], ["width", $c107], ["modulus", $c108], ["rating", $c109], ["strength", $c110], ["speed", $c111], ["momentary_factor", $c112], ["least_pulley_diameter", $c113], ["largest_wrap_pressure", $c114], ["in_plane_shear_stiffness", $c115], ["pulley_cover", $c116], ["carry_cover", $c117], ["carcass", $c118], ["thickness", $c119], ["cover_shear_modulus", $c120], ["mass", $c121], ["provenance", $c122], ["sources", $c123]]);
const $c5 = $made(tables$Table, $c744, [Belt, $c1, $c795]);
const $c752 = $made(Entry, $c759, ["belt", $c5, true, "", "a [belt] table", "belt", ""]);
const $c798 = ["kind", "least", "most"];
const $c183 = $made(Name, $c770, [60]);
const $c165 = $made(Entry, $c759, ["name", $c183, true, "", "name = \"head\"", "name", ""]);
const $c185 = $made(Limit, $c765, ["length", 0.001, 1000.0, false, false]);
const $c184 = $made(Quantity, $c129, ["length", $c185]);
const $c166 = $made(Entry, $c759, ["diameter", $c184, true, "", "", "diameter", ""]);
const $c187 = $made(Limit, $c765, ["angle", 0.017453292519943295, 12.566370614359172, false, false]);
const $c186 = $made(Quantity, $c129, ["angle", $c187]);
const $c167 = $made(Entry, $c759, ["wrap_angle", $c186, true, "wrap", "", "wrap_angle", "belt_path"]);
const $c692 = $made(Limit, $c765, ["length", -100000.0, 100000.0, false, false]);
const $c807 = $made(Quantity, $c129, ["length", $c692]);
const $c802 = $made(Entry, $c759, ["x", $c807, true, "", "", "x", ""]);
const $c808 = $made(Quantity, $c129, ["length", $c692]);
const $c803 = $made(Entry, $c759, ["y", $c808, true, "", "", "y", ""]);
const $c810 = ["clockwise", "counterclockwise"];
const $c809 = $made(Choice, $c782, [$c810]);
const $c804 = $made(Entry, $c759, ["turn", $c809, false, "", "", "turn", ""]);
const $c817 = $made(Quantity, $c129, ["length", $c692]);
const $c814 = $made(Entry, $c759, ["x", $c817, true, "", "", "x", ""]);
const $c818 = $made(Quantity, $c129, ["length", $c692]);
const $c815 = $made(Entry, $c759, ["y", $c818, true, "", "", "y", ""]);
const $c693 = $made(Limit, $c765, ["length", 0.0, 1000.0, false, false]);
const $c819 = $made(Quantity, $c129, ["length", $c693]);
const $c816 = $made(Entry, $c759, ["diameter", $c819, false, "", "", "diameter", ""]);
const $c812 = [$c814, $c815, $c816, $c804];
const $c813 = new Map([["x", $c814], ["y", $c815], ["diameter", $c816], ["turn", $c804]]);
const $c811 = $made(tables$Table, $c744, [Point, $c812, $c813]);
const $c805 = $made(Entry, $c759, ["before", $c811, true, "", "a table with x and y", "before", ""]);
const $c806 = $made(Entry, $c759, ["after", $c811, true, "", "a table with x and y", "after", ""]);
const $c800 = [$c802, $c803, $c804, $c805, $c806];
const $c801 = new Map([["x", $c802], ["y", $c803], ["turn", $c804], ["before", $c805], ["after", $c806]]);
const $c188 = $made(tables$Table, $c744, [Point, $c800, $c801]);
const $c168 = $made(Entry, $c759, ["belt_path", $c188, false, "", "", "belt_path", ""]);
const $c820 = $made(Name, $c770, [500]);
const $c844 = $made(Name, $c770, [500]);
const $c824 = $made(Entry, $c759, ["preset", $c844, false, "", "", "preset", ""]);
const $c845 = $made(Name, $c770, [60]);
const $c825 = $made(Entry, $c759, ["name", $c845, false, "", "", "name", ""]);
const $c846 = $made(Text, $c762, [200, false]);
const $c826 = $made(Entry, $c759, ["title", $c846, false, "", "", "title", ""]);
const $c847 = $made(Text, $c762, [5000, true]);
const $c827 = $made(Entry, $c759, ["description", $c847, false, "", "", "description", ""]);
const $c720 = ["bare", "rubber", "polyurethane", "ceramic"];
const $c848 = $made(Choice, $c782, [$c720]);
const $c828 = $made(Entry, $c759, ["surface", $c848, false, "", "", "surface", ""]);
const $c703 = $made(Limit, $c765, ["length", 0.0, 1.0, false, false]);
const $c849 = $made(Quantity, $c129, ["length", $c703]);
const $c829 = $made(Entry, $c759, ["thickness", $c849, false, "", "", "thickness", ""]);
const $c706 = $made(Limit, $c765, ["pressure", 1000.0, Infinity, false, false]);
const $c850 = $made(Quantity, $c129, ["pressure", $c706]);
const $c830 = $made(Entry, $c759, ["elastic_modulus", $c850, false, "", "", "elastic_modulus", ""]);
const $c704 = $made(Limit, $c765, ["pressure", 1000.0, Infinity, false, true]);
const $c852 = $made(Quantity, $c129, ["pressure", $c704]);
const $c851 = $made(WordOr, $c796, ["rigid", $c852, Infinity]);
const $c831 = $made(Entry, $c759, ["shear_modulus", $c851, false, "", "", "shear_modulus", ""]);
const $c705 = $made(Limit, $c765, ["pressure", 1000.0, Infinity, false, true]);
const $c854 = $made(Quantity, $c129, ["pressure", $c705]);
const $c853 = $made(WordOr, $c796, ["rigid", $c854, Infinity]);
const $c832 = $made(Entry, $c759, ["compression_modulus", $c853, false, "", "", "compression_modulus", ""]);
const $c730 = ["square", "strip"];
const $c862 = $made(Choice, $c782, [$c730]);
const $c857 = $made(Entry, $c759, ["shape", $c862, false, "", "", "shape", ""]);
const $c864 = $made(Limit, $c765, ["length", 0.0001, 10.0, false, false]);
const $c863 = $made(Quantity, $c129, ["length", $c864]);
const $c858 = $made(Entry, $c759, ["width", $c863, true, "", "", "width", ""]);
const $c866 = $made(Limit, $c765, ["length", 0.0001, 1.0, false, false]);
const $c865 = $made(Quantity, $c129, ["length", $c866]);
const $c859 = $made(Entry, $c759, ["height", $c865, false, "", "", "height", ""]);
const $c868 = $made(Limit, $c765, ["number", 0.0, 10.0, false, false]);
const $c867 = $made(Quantity, $c129, ["number", $c868]);
const $c860 = $made(Entry, $c759, ["stiffening", $c867, false, "", "", "stiffening", ""]);
const $c870 = $made(Limit, $c765, ["number", 0.01, 1.0, false, false]);
const $c869 = $made(Quantity, $c129, ["number", $c870]);
const $c861 = $made(Entry, $c759, ["contact_fraction", $c869, false, "", "", "contact_fraction", ""]);
const $c855 = [$c857, $c858, $c859, $c860, $c861];
const $c856 = new Map([["shape", $c857], ["width", $c858], ["height", $c859], ["stiffening", $c860], ["contact_fraction", $c861]]);
const $c66 = $made(tables$Table, $c744, [Block, $c855, $c856]);
const $c833 = $made(Entry, $c759, ["block", $c66, false, "", "", "block", ""]);
const $c707 = $made(Limit, $c765, ["wear_coefficient", 0.0, 1.0, false, false]);
const $c871 = $made(Quantity, $c129, ["wear_coefficient", $c707]);
const $c834 = $made(Entry, $c759, ["wear_coefficient", $c871, false, "", "", "wear_coefficient", ""]);
const $c708 = $made(Limit, $c765, ["number", 0.0, 1.0, false, false]);
const $c872 = $made(Quantity, $c129, ["number", $c708]);
const $c835 = $made(Entry, $c759, ["belt_energy_share", $c872, false, "", "", "belt_energy_share", ""]);
const $c709 = $made(Limit, $c765, ["pressure", 0.0, Infinity, true, false]);
const $c873 = $made(Quantity, $c129, ["pressure", $c709]);
const $c836 = $made(Entry, $c759, ["bond_strength", $c873, false, "", "", "bond_strength", ""]);
const $c710 = $made(Limit, $c765, ["pressure", 0.0, Infinity, true, false]);
const $c874 = $made(Quantity, $c129, ["pressure", $c710]);
const $c837 = $made(Entry, $c759, ["fatigue_limit", $c874, false, "", "", "fatigue_limit", ""]);
const $c883 = $made(Limit, $c765, ["number", 0.0, Infinity, false, false]);
const $c882 = $made(Quantity, $c129, ["number", $c883]);
const $c877 = $made(Entry, $c759, ["material", $c882, true, "", "", "material", ""]);
const $c885 = $made(Limit, $c765, ["number", 0.0, Infinity, false, false]);
const $c884 = $made(Quantity, $c129, ["number", $c885]);
const $c878 = $made(Entry, $c759, ["installation", $c884, true, "", "", "installation", ""]);
const $c886 = $made(Name, $c770, [12]);
const $c879 = $made(Entry, $c759, ["currency", $c886, true, "", "", "currency", ""]);
const $c888 = $made(Limit, $c765, ["area", 0.0, Infinity, true, false]);
const $c887 = $made(Quantity, $c129, ["area", $c888]);
const $c880 = $made(Entry, $c759, ["area", $c887, true, "", "", "area", ""]);
const $c890 = $made(Quantity, $c129, ["number", null]);
const $c889 = $made(Rows, $c798, [$c890, 2, 2]);
const $c881 = $made(Entry, $c759, ["life_years", $c889, true, "", "", "life_years", ""]);
const $c875 = [$c877, $c878, $c879, $c880, $c881];
const $c876 = new Map([["material", $c877], ["installation", $c878], ["currency", $c879], ["area", $c880], ["life_years", $c881]]);
const $c63 = $made(tables$Table, $c744, [Cost, $c875, $c876]);
const $c838 = $made(Entry, $c759, ["cost", $c63, false, "", "", "cost", ""]);
const $c892 = $made(Limit, $c765, ["speed", 0.0, Infinity, true, false]);
const $c891 = $made(Quantity, $c129, ["speed", $c892]);
const $c839 = $made(Entry, $c759, ["slip_speed", $c891, false, "", "", "slip_speed", ""]);
const $c894 = $made(Limit, $c765, ["temperature", 0.0, Infinity, false, false]);
const $c893 = $made(Quantity, $c129, ["temperature", $c894]);
const $c840 = $made(Entry, $c759, ["temperature", $c893, false, "", "", "temperature", ""]);
const $c901 = $made(Name, $c770, [60]);
const $c898 = $made(Entry, $c759, ["condition", $c901, true, "", "", "condition", ""]);
const $c903 = $made(Limit, $c765, ["number", 0.0, 10.0, true, false]);
const $c902 = $made(Quantity, $c129, ["number", $c903]);
const $c899 = $made(Entry, $c759, ["factor", $c902, true, "", "", "factor", ""]);
const $c900 = $made(Entry, $c759, ["provenance", $c2, true, "", "", "provenance", ""]);
const $c896 = [$c898, $c899, $c900];
const $c897 = new Map([["condition", $c898], ["factor", $c899], ["provenance", $c900]]);
const $c67 = $made(tables$Table, $c744, [ConditionFactor, $c896, $c897]);
const $c895 = $made(Rows, $c798, [$c67, 0, 20]);
const $c841 = $made(Entry, $c759, ["condition_factor", $c895, false, "", "", "condition_factor", ""]);
const $c905 = ["tag", "tables"];
const $c932 = ["integral-log"];
const $c931 = $made(Choice, $c782, [$c932]);
const $c914 = $made(Entry, $c759, ["kind", $c931, true, "", "", "kind", ""]);
const $c933 = $made(Name, $c770, [60]);
const $c915 = $made(Entry, $c759, ["condition", $c933, false, "", "", "condition", ""]);
const $c916 = $made(Entry, $c759, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c917 = $made(Entry, $c759, ["condition_source", $c2, false, "", "", "condition_source", ""]);
const $c946 = $made(Name, $c770, [120]);
const $c945 = $made(Rows, $c798, [$c946, 1, 1000]);
const $c936 = $made(Entry, $c759, ["parameters", $c945, true, "", "", "parameters", ""]);
const $c947 = $made(Rows, $c798, [$c890, 1, 1000]);
const $c937 = $made(Entry, $c759, ["values", $c947, true, "", "", "values", ""]);
const $c949 = $made(Rows, $c798, [$c890, 1, 1000]);
const $c948 = $made(Rows, $c798, [$c949, 1, 1000]);
const $c938 = $made(Entry, $c759, ["covariance", $c948, true, "", "", "covariance", ""]);
const $c951 = $made(Limit, $c765, ["number", 0.0, Infinity, false, false]);
const $c950 = $made(Quantity, $c129, ["number", $c951]);
const $c939 = $made(Entry, $c759, ["residual_noise", $c950, false, "", "", "residual_noise", ""]);
const $c953 = $made(Limit, $c765, ["number", 1.0, Infinity, false, false]);
const $c952 = $made(Quantity, $c129, ["number", $c953]);
const $c940 = $made(Entry, $c759, ["coverage_factor", $c952, false, "", "", "coverage_factor", ""]);
const $c954 = $made(Text, $c762, [60, false]);
const $c941 = $made(Entry, $c759, ["date", $c954, false, "", "", "date", ""]);
const $c955 = $made(Text, $c762, [500, false]);
const $c942 = $made(Entry, $c759, ["method", $c955, false, "", "", "method", ""]);
const $c957 = $made(Text, $c762, [2000, true]);
const $c956 = $made(Rows, $c798, [$c957, 0, 50]);
const $c943 = $made(Entry, $c759, ["misfit", $c956, false, "", "", "misfit", ""]);
const $c958 = $made(Text, $c762, [500, false]);
const $c944 = $made(Entry, $c759, ["misfit_accepted", $c958, false, "", "", "misfit_accepted", ""]);
const $c934 = [$c936, $c937, $c938, $c939, $c940, $c941, $c942, $c943, $c944];
const $c935 = new Map([["parameters", $c936], ["values", $c937], ["covariance", $c938], ["residual_noise", $c939], ["coverage_factor", $c940], ["date", $c941], ["method", $c942], ["misfit", $c943], ["misfit_accepted", $c944]]);
const $c74 = $made(tables$Table, $c744, [Fit, $c934, $c935]);
const $c918 = $made(Entry, $c759, ["fit", $c74, false, "", "", "fit", ""]);
const $c961 = ["lagging shear", "cover shear"];
const $c960 = $made(Choice, $c782, [$c961]);
const $c959 = $made(Rows, $c798, [$c960, 0, 2]);
const $c919 = $made(Entry, $c759, ["slip_includes", $c959, false, "", "", "slip_includes", ""]);
const $c968 = $made(Limit, $c765, ["speed", 0.0, Infinity, true, false]);
const $c967 = $made(Quantity, $c129, ["speed", $c968]);
const $c966 = $made(Rows, $c798, [$c967, 2, 100]);
const $c964 = $made(Entry, $c759, ["slip_speed", $c966, true, "", "", "at", ""]);
const $c969 = $made(Rows, $c798, [$c902, 2, 100]);
const $c965 = $made(Entry, $c759, ["factor", $c969, true, "", "", "factor", ""]);
const $c962 = [$c964, $c965, $c900];
const $c963 = new Map([["slip_speed", $c964], ["factor", $c965], ["provenance", $c900]]);
const $c72 = $made(tables$Table, $c744, [FrictionFactor, $c962, $c963]);
const $c920 = $made(Entry, $c759, ["slip_speed_factor", $c72, false, "", "", "slip_speed_factor", ""]);
const $c975 = $made(Limit, $c765, ["temperature", 0.0, Infinity, false, false]);
const $c974 = $made(Quantity, $c129, ["temperature", $c975]);
const $c973 = $made(Rows, $c798, [$c974, 2, 100]);
const $c972 = $made(Entry, $c759, ["temperature", $c973, true, "", "", "at", ""]);
const $c970 = [$c972, $c965, $c900];
const $c971 = new Map([["temperature", $c972], ["factor", $c965], ["provenance", $c900]]);
const $c73 = $made(tables$Table, $c744, [FrictionFactor, $c970, $c971]);
const $c921 = $made(Entry, $c759, ["temperature_factor", $c73, false, "", "", "temperature_factor", ""]);
const $c922 = $made(Entry, $c759, ["notes", $c956, false, "", "", "notes", ""]);
const $c978 = $made(Limit, $c765, ["pressure", 0.0, 1000000000.0, true, false]);
const $c977 = $made(Quantity, $c129, ["pressure", $c978]);
const $c976 = $made(Rows, $c798, [$c977, 2, 2]);
const $c923 = $made(Entry, $c759, ["tested_pressure", $c976, false, "", "", "tested_pressure", ""]);
const $c980 = $made(Limit, $c765, ["length", 0.0, 1.0, true, false]);
const $c979 = $made(Quantity, $c129, ["length", $c980]);
const $c924 = $made(Entry, $c759, ["tested_slip", $c979, false, "", "", "tested_slip", ""]);
const $c982 = $made(Limit, $c765, ["speed", 0.0, Infinity, true, false]);
const $c981 = $made(Quantity, $c129, ["speed", $c982]);
const $c925 = $made(Entry, $c759, ["tested_slip_speed", $c981, false, "", "", "tested_slip_speed", ""]);
const $c987 = $made(Entry, $c759, ["pressure", $c977, true, "", "", "pressure", ""]);
const $c993 = $made(Limit, $c765, ["number", 0.0, 5.0, true, false]);
const $c992 = $made(Quantity, $c129, ["number", $c993]);
const $c988 = $made(Entry, $c759, ["peak_friction", $c992, true, "", "", "peak_friction", ""]);
const $c989 = $made(Entry, $c759, ["peak_slip", $c979, true, "", "", "peak_slip", ""]);
const $c995 = $made(Limit, $c765, ["per_length", -1000000.0, 0.0, false, false]);
const $c994 = $made(Quantity, $c129, ["per_length", $c995]);
const $c990 = $made(Entry, $c759, ["post_peak_slope", $c994, false, "", "", "post_peak_slope", ""]);
const $c991 = $made(Entry, $c759, ["residual_friction", $c992, false, "", "", "residual_friction", ""]);
const $c985 = [$c987, $c988, $c989, $c990, $c991];
const $c986 = new Map([["pressure", $c987], ["peak_friction", $c988], ["peak_slip", $c989], ["post_peak_slope", $c990], ["residual_friction", $c991]]);
const $c984 = $made(tables$Table, $c744, [null, $c985, $c986]);
const $c983 = $made(Rows, $c798, [$c984, 1, 200]);
const $c926 = $made(Entry, $c759, ["knots", $c983, false, "", "", "knots", ""]);
const $c1000 = $made(Entry, $c759, ["from", $c977, true, "", "", "from", ""]);
const $c1001 = $made(Entry, $c759, ["to", $c977, true, "", "", "to", ""]);
const $c1006 = $made(Text, $c762, [300, false]);
const $c1002 = $made(Entry, $c759, ["A", $c1006, true, "", "", "A", ""]);
const $c1003 = $made(Entry, $c759, ["b", $c1006, true, "", "", "b", ""]);
const $c1004 = $made(Entry, $c759, ["post_peak_slope", $c1006, false, "", "", "post_peak_slope", ""]);
const $c1005 = $made(Entry, $c759, ["residual_friction", $c1006, false, "", "", "residual_friction", ""]);
const $c998 = [$c1000, $c1001, $c1002, $c1003, $c1004, $c1005];
const $c999 = new Map([["from", $c1000], ["to", $c1001], ["A", $c1002], ["b", $c1003], ["post_peak_slope", $c1004], ["residual_friction", $c1005]]);
const $c997 = $made(tables$Table, $c744, [null, $c998, $c999]);
const $c996 = $made(Rows, $c798, [$c997, 1, 50]);
const $c927 = $made(Entry, $c759, ["pieces", $c996, false, "", "", "pieces", ""]);
const $c1007 = $made(Text, $c762, [20, false]);
const $c928 = $made(Entry, $c759, ["slip_unit", $c1007, false, "", "", "slip_unit", ""]);
const $c1008 = $made(Text, $c762, [20, false]);
const $c929 = $made(Entry, $c759, ["pressure_unit", $c1008, false, "", "", "pressure_unit", ""]);
const $c1010 = $made(Limit, $c765, ["number", 0.0, 0.5, false, false]);
const $c1009 = $made(Quantity, $c129, ["number", $c1010]);
const $c930 = $made(Entry, $c759, ["continuity", $c1009, false, "", "", "continuity", ""]);
const $c912 = [$c914, $c915, $c916, $c917, $c918, $c919, $c920, $c921, $c922, $c923, $c924, $c925, $c926, $c927, $c928, $c929, $c930];
const $c913 = new Map([["kind", $c914], ["condition", $c915], ["provenance", $c916], ["condition_source", $c917], ["fit", $c918], ["slip_includes", $c919], ["slip_speed_factor", $c920], ["temperature_factor", $c921], ["notes", $c922], ["tested_pressure", $c923], ["tested_slip", $c924], ["tested_slip_speed", $c925], ["knots", $c926], ["pieces", $c927], ["slip_unit", $c928], ["pressure_unit", $c929], ["continuity", $c930]]);
const $c907 = $made(tables$Table, $c744, [IntegralLog, $c912, $c913]);
const $c1016 = ["constant"];
const $c1015 = $made(Choice, $c782, [$c1016]);
const $c1013 = $made(Entry, $c759, ["kind", $c1015, true, "", "", "kind", ""]);
const $c1014 = $made(Entry, $c759, ["friction", $c992, true, "", "", "friction_coefficient", ""]);
const $c1011 = [$c1013, $c915, $c916, $c917, $c918, $c919, $c920, $c921, $c922, $c923, $c924, $c925, $c1014];
const $c1012 = new Map([["kind", $c1013], ["condition", $c915], ["provenance", $c916], ["condition_source", $c917], ["fit", $c918], ["slip_includes", $c919], ["slip_speed_factor", $c920], ["temperature_factor", $c921], ["notes", $c922], ["tested_pressure", $c923], ["tested_slip", $c924], ["tested_slip_speed", $c925], ["friction", $c1014]]);
const $c908 = $made(tables$Table, $c744, [Constant, $c1011, $c1012]);
const $c1022 = ["elastic-plastic"];
const $c1021 = $made(Choice, $c782, [$c1022]);
const $c1019 = $made(Entry, $c759, ["kind", $c1021, true, "", "", "kind", ""]);
const $c1024 = $made(Limit, $c765, ["pressure_per_length", 0.0, 1000000000000000.0, true, false]);
const $c1023 = $made(Quantity, $c129, ["pressure_per_length", $c1024]);
const $c1020 = $made(Entry, $c759, ["stiffness", $c1023, true, "", "", "stiffness", ""]);
const $c1017 = [$c1019, $c915, $c916, $c917, $c918, $c919, $c920, $c921, $c922, $c923, $c924, $c925, $c1020, $c1014];
const $c1018 = new Map([["kind", $c1019], ["condition", $c915], ["provenance", $c916], ["condition_source", $c917], ["fit", $c918], ["slip_includes", $c919], ["slip_speed_factor", $c920], ["temperature_factor", $c921], ["notes", $c922], ["tested_pressure", $c923], ["tested_slip", $c924], ["tested_slip_speed", $c925], ["stiffness", $c1020], ["friction", $c1014]]);
const $c909 = $made(tables$Table, $c744, [ElasticPlastic, $c1017, $c1018]);
const $c1032 = ["power"];
const $c1031 = $made(Choice, $c782, [$c1032]);
const $c1027 = $made(Entry, $c759, ["kind", $c1031, true, "", "", "kind", ""]);
const $c1028 = $made(Entry, $c759, ["friction", $c992, true, "", "", "friction_coefficient", ""]);
const $c1029 = $made(Entry, $c759, ["reference_pressure", $c977, true, "", "", "reference_pressure", ""]);
const $c1030 = $made(Entry, $c759, ["exponent", $c890, true, "", "", "exponent", ""]);
const $c1025 = [$c1027, $c915, $c916, $c917, $c918, $c919, $c920, $c921, $c922, $c923, $c924, $c925, $c1028, $c1029, $c1030];
const $c1026 = new Map([["kind", $c1027], ["condition", $c915], ["provenance", $c916], ["condition_source", $c917], ["fit", $c918], ["slip_includes", $c919], ["slip_speed_factor", $c920], ["temperature_factor", $c921], ["notes", $c922], ["tested_pressure", $c923], ["tested_slip", $c924], ["tested_slip_speed", $c925], ["friction", $c1028], ["reference_pressure", $c1029], ["exponent", $c1030]]);
const $c910 = $made(tables$Table, $c744, [PressurePower, $c1025, $c1026]);
const $c1039 = ["table"];
const $c1038 = $made(Choice, $c782, [$c1039]);
const $c1035 = $made(Entry, $c759, ["kind", $c1038, true, "", "", "kind", ""]);
const $c1042 = $made(Limit, $c765, ["length", 0.0, 1.0, false, false]);
const $c1041 = $made(Quantity, $c129, ["length", $c1042]);
const $c1040 = $made(Rows, $c798, [$c1041, 2, 1000]);
const $c1036 = $made(Entry, $c759, ["slip", $c1040, true, "", "", "slip", ""]);
const $c1047 = $made(Entry, $c759, ["pressure", $c977, true, "", "", "pressure", ""]);
const $c1051 = $made(Limit, $c765, ["number", 0.0, 5.0, false, false]);
const $c1050 = $made(Quantity, $c129, ["number", $c1051]);
const $c1049 = $made(Rows, $c798, [$c1050, 2, 1000]);
const $c1048 = $made(Entry, $c759, ["friction", $c1049, true, "", "", "values", ""]);
const $c1045 = [$c1047, $c1048];
const $c1046 = new Map([["pressure", $c1047], ["friction", $c1048]]);
const $c1044 = $made(tables$Table, $c744, [null, $c1045, $c1046]);
const $c1043 = $made(Rows, $c798, [$c1044, 1, 200]);
const $c1037 = $made(Entry, $c759, ["rows", $c1043, true, "", "", "rows", ""]);
const $c1033 = [$c1035, $c915, $c916, $c917, $c918, $c919, $c920, $c921, $c922, $c1036, $c1037];
const $c1034 = new Map([["kind", $c1035], ["condition", $c915], ["provenance", $c916], ["condition_source", $c917], ["fit", $c918], ["slip_includes", $c919], ["slip_speed_factor", $c920], ["temperature_factor", $c921], ["notes", $c922], ["slip", $c1036], ["rows", $c1037]]);
const $c911 = $made(tables$Table, $c744, [MeasuredTable, $c1033, $c1034]);
const $c906 = new Map([["integral-log", $c907], ["constant", $c908], ["elastic-plastic", $c909], ["power", $c910], ["table", $c911]]);
const $c70 = $made(Variant, $c905, ["kind", $c906]);
const $c904 = $made(OneOrMore, $c767, [$c70, 50]);
const $c842 = $made(Entry, $c759, ["law", $c904, false, "", "", "law", ""]);
const $c843 = $made(Entry, $c759, ["notes", $c956, false, "", "", "notes", ""]);
const $c822 = [$c824, $c825, $c826, $c827, $c828, $c829, $c830, $c831, $c832, $c833, $c834, $c835, $c836, $c837, $c838, $c839, $c840, $c841, $c842, $c122, $c123, $c843];
const $c823 = new Map([["preset", $c824], ["name", $c825], ["title", $c826], ["description", $c827], ["surface", $c828], ["thickness", $c829], ["elastic_modulus", $c830], ["shear_modulus", $c831], ["compression_modulus", $c832], ["block", $c833], ["wear_coefficient", $c834], ["belt_energy_share", $c835], ["bond_strength", $c836], ["fatigue_limit", $c837], ["cost", $c838], ["slip_speed", $c839], ["temperature", $c840], ["condition_factor", $c841], ["law", $c842], ["provenance", $c122], ["sources", $c123], ["notes", $c843]]);
const $c821 = $made(tables$Table, $c744, [Lagging, $c822, $c823]);
const $c189 = $made(TextOr, $c768, [$c820, $c821]);
const $c169 = $made(Entry, $c759, ["lagging", $c189, true, "", "lagging = \"diamond-rubber\"", "lagging", ""]);
const $c170 = $made(Entry, $c759, ["condition", $c190, false, "", "", "condition", ""]);
const $c192 = $made(Limit, $c765, ["force", 0.1, 1000000000.0, false, false]);
const $c191 = $made(Quantity, $c129, ["force", $c192]);
const $c171 = $made(Entry, $c759, ["entry_tension", $c191, false, "", "", "entry_tension", ""]);
const $c172 = $made(Entry, $c759, ["exit_tension", $c191, false, "", "", "exit_tension", ""]);
const $c193 = $made(Quantity, $c129, ["force", null]);
const $c173 = $made(Entry, $c759, ["effective_tension", $c193, false, "", "", "effective_tension", ""]);
const $c194 = $made(Quantity, $c129, ["torque", null]);
const $c174 = $made(Entry, $c759, ["torque", $c194, false, "", "", "torque", ""]);
const $c195 = $made(Quantity, $c129, ["power", null]);
const $c175 = $made(Entry, $c759, ["power", $c195, false, "", "", "power", ""]);
const $c198 = $made(Limit, $c765, ["length", -1.0, 1.0, false, false]);
const $c197 = $made(Quantity, $c129, ["length", $c198]);
const $c196 = $made(WordOr, $c796, ["formula", $c197, null]);
const $c176 = $made(Entry, $c759, ["overrun", $c196, false, "", "", "overrun", ""]);
const $c199 = $made(Flag, [], []);
const $c177 = $made(Entry, $c759, ["recovery", $c199, false, "", "", "recovery", ""]);
const $c201 = $made(Limit, $c765, ["length", 0.0, 1.0, true, false]);
const $c200 = $made(Quantity, $c129, ["length", $c201]);
const $c178 = $made(Entry, $c759, ["creep_limit", $c200, false, "", "", "creep_limit", ""]);
const $c727 = ["pulley", "carry"];
const $c202 = $made(Choice, $c782, [$c727]);
const $c179 = $made(Entry, $c759, ["side", $c202, false, "", "", "side", ""]);
const $c204 = $made(Limit, $c765, ["mass", 0.0, 1000000.0, true, false]);
const $c203 = $made(Quantity, $c129, ["mass", $c204]);
const $c180 = $made(Entry, $c759, ["mass", $c203, false, "", "", "mass", ""]);
const $c1405 = ["dimension", "diameters", "rows", "within"];
const $c1482 = ["kinds"];
const $c1484 = $made(Quantity, $c129, ["length", null]);
const $c1485 = $made(Quantity, $c129, ["length", null]);
const $c1483 = [$c1484, $c1485];
const $c1408 = $made(_Pair, $c1482, [$c1483]);
const $c1406 = $made(Rows, $c798, [$c1408, 0, 500]);
const $c1412 = $made(Entry, $c759, ["rows", $c1406, false, "", "", "rows", ""]);
const $c1417 = $made(Quantity, $c129, ["length", null]);
const $c1413 = $made(Entry, $c759, ["crown", $c1417, false, "", "", "crown", ""]);
const $c1419 = $made(Limit, $c765, ["number", 0.0, 100.0, false, false]);
const $c1418 = $made(Quantity, $c129, ["number", $c1419]);
const $c1414 = $made(Entry, $c759, ["factor", $c1418, false, "", "", "factor", ""]);
const $c1421 = $made(Limit, $c765, ["length", 0.0, Infinity, false, false]);
const $c1420 = $made(Quantity, $c129, ["length", $c1421]);
const $c1415 = $made(Entry, $c759, ["uncertainty", $c1420, false, "", "", "uncertainty", ""]);
const $c1423 = ["radius", "diameter"];
const $c1422 = $made(Choice, $c782, [$c1423]);
const $c1416 = $made(Entry, $c759, ["on", $c1422, false, "", "", "on", ""]);
const $c1410 = [$c1412, $c1413, $c1414, $c1415, $c1416];
const $c1411 = new Map([["rows", $c1412], ["crown", $c1413], ["factor", $c1414], ["uncertainty", $c1415], ["on", $c1416]]);
const $c1409 = $made(tables$Table, $c744, [null, $c1410, $c1411]);
const $c1407 = $made(TextOr, $c768, [$c1406, $c1409]);
const $c1063 = $made(Profile, $c1405, ["length", true, $c1406, $c1407]);
const $c1054 = $made(Entry, $c759, ["shell_profile", $c1063, false, "", "", "shell_profile", ""]);
const $c1487 = $made(Quantity, $c129, ["length", null]);
const $c1488 = $made(Quantity, $c129, ["length", null]);
const $c1486 = [$c1487, $c1488];
const $c1426 = $made(_Pair, $c1482, [$c1486]);
const $c1424 = $made(Rows, $c798, [$c1426, 0, 500]);
const $c1430 = $made(Entry, $c759, ["rows", $c1424, false, "", "", "rows", ""]);
const $c1435 = $made(Quantity, $c129, ["length", null]);
const $c1431 = $made(Entry, $c759, ["crown", $c1435, false, "", "", "crown", ""]);
const $c1437 = $made(Limit, $c765, ["number", 0.0, 100.0, false, false]);
const $c1436 = $made(Quantity, $c129, ["number", $c1437]);
const $c1432 = $made(Entry, $c759, ["factor", $c1436, false, "", "", "factor", ""]);
const $c1439 = $made(Limit, $c765, ["length", 0.0, Infinity, false, false]);
const $c1438 = $made(Quantity, $c129, ["length", $c1439]);
const $c1433 = $made(Entry, $c759, ["uncertainty", $c1438, false, "", "", "uncertainty", ""]);
const $c1440 = $made(Choice, $c782, [$c1423]);
const $c1434 = $made(Entry, $c759, ["on", $c1440, false, "", "", "on", ""]);
const $c1428 = [$c1430, $c1431, $c1432, $c1433, $c1434];
const $c1429 = new Map([["rows", $c1430], ["crown", $c1431], ["factor", $c1432], ["uncertainty", $c1433], ["on", $c1434]]);
const $c1427 = $made(tables$Table, $c744, [null, $c1428, $c1429]);
const $c1425 = $made(TextOr, $c768, [$c1424, $c1427]);
const $c1064 = $made(Profile, $c1405, ["length", true, $c1424, $c1425]);
const $c1055 = $made(Entry, $c759, ["worn_depth", $c1064, false, "", "", "worn_depth", ""]);
const $c1490 = $made(Quantity, $c129, ["length", null]);
const $c1491 = $made(Quantity, $c129, ["length", null]);
const $c1489 = [$c1490, $c1491];
const $c1443 = $made(_Pair, $c1482, [$c1489]);
const $c1441 = $made(Rows, $c798, [$c1443, 0, 500]);
const $c1447 = $made(Entry, $c759, ["rows", $c1441, false, "", "", "rows", ""]);
const $c1452 = $made(Quantity, $c129, ["length", null]);
const $c1448 = $made(Entry, $c759, ["crown", $c1452, false, "", "", "crown", ""]);
const $c1454 = $made(Limit, $c765, ["number", 0.0, 100.0, false, false]);
const $c1453 = $made(Quantity, $c129, ["number", $c1454]);
const $c1449 = $made(Entry, $c759, ["factor", $c1453, false, "", "", "factor", ""]);
const $c1456 = $made(Limit, $c765, ["length", 0.0, Infinity, false, false]);
const $c1455 = $made(Quantity, $c129, ["length", $c1456]);
const $c1450 = $made(Entry, $c759, ["uncertainty", $c1455, false, "", "", "uncertainty", ""]);
const $c1457 = $made(Choice, $c782, [$c1423]);
const $c1451 = $made(Entry, $c759, ["on", $c1457, false, "", "", "on", ""]);
const $c1445 = [$c1447, $c1448, $c1449, $c1450, $c1451];
const $c1446 = new Map([["rows", $c1447], ["crown", $c1448], ["factor", $c1449], ["uncertainty", $c1450], ["on", $c1451]]);
const $c1444 = $made(tables$Table, $c744, [null, $c1445, $c1446]);
const $c1442 = $made(TextOr, $c768, [$c1441, $c1444]);
const $c1065 = $made(Profile, $c1405, ["length", true, $c1441, $c1442]);
const $c1056 = $made(Entry, $c759, ["build_up", $c1065, false, "", "", "build_up", ""]);
const $c1067 = $made(Limit, $c765, ["number", -0.1, 0.1, false, false]);
const $c1066 = $made(Quantity, $c129, ["number", $c1067]);
const $c1057 = $made(Entry, $c759, ["misalignment", $c1066, false, "", "", "misalignment", ""]);
const $c1069 = $made(Limit, $c765, ["length", -0.1, 0.1, false, false]);
const $c1068 = $made(Quantity, $c129, ["length", $c1069]);
const $c1058 = $made(Entry, $c759, ["deflection", $c1068, false, "", "", "deflection", ""]);
const $c1493 = $made(Quantity, $c129, ["length", null]);
const $c1494 = $made(Quantity, $c129, ["force_per_width", null]);
const $c1492 = [$c1493, $c1494];
const $c1460 = $made(_Pair, $c1482, [$c1492]);
const $c1458 = $made(Rows, $c798, [$c1460, 0, 500]);
const $c1464 = $made(Entry, $c759, ["rows", $c1458, false, "", "", "rows", ""]);
const $c1468 = $made(Quantity, $c129, ["force_per_width", null]);
const $c1465 = $made(Entry, $c759, ["crown", $c1468, false, "", "", "crown", ""]);
const $c1470 = $made(Limit, $c765, ["number", 0.0, 100.0, false, false]);
const $c1469 = $made(Quantity, $c129, ["number", $c1470]);
const $c1466 = $made(Entry, $c759, ["factor", $c1469, false, "", "", "factor", ""]);
const $c1472 = $made(Limit, $c765, ["force_per_width", 0.0, Infinity, false, false]);
const $c1471 = $made(Quantity, $c129, ["force_per_width", $c1472]);
const $c1467 = $made(Entry, $c759, ["uncertainty", $c1471, false, "", "", "uncertainty", ""]);
const $c1462 = [$c1464, $c1465, $c1466, $c1467];
const $c1463 = new Map([["rows", $c1464], ["crown", $c1465], ["factor", $c1466], ["uncertainty", $c1467]]);
const $c1461 = $made(tables$Table, $c744, [null, $c1462, $c1463]);
const $c1459 = $made(TextOr, $c768, [$c1458, $c1461]);
const $c1070 = $made(Profile, $c1405, ["force_per_width", false, $c1458, $c1459]);
const $c1059 = $made(Entry, $c759, ["entry_profile", $c1070, false, "", "", "entry_profile", ""]);
const $c1080 = ["pulley"];
const $c1079 = $made(Choice, $c782, [$c1080]);
const $c1077 = $made(Entry, $c759, ["kind", $c1079, true, "", "", "kind", ""]);
const $c1082 = $made(Limit, $c765, ["length", 0.0, 100000.0, true, false]);
const $c1081 = $made(Quantity, $c129, ["length", $c1082]);
const $c1078 = $made(Entry, $c759, ["distance", $c1081, true, "", "", "distance", ""]);
const $c1075 = [$c1077, $c1078];
const $c1076 = new Map([["kind", $c1077], ["distance", $c1078]]);
const $c1073 = $made(tables$Table, $c744, [GrippingPulley, $c1075, $c1076]);
const $c1091 = ["transition"];
const $c1090 = $made(Choice, $c782, [$c1091]);
const $c1085 = $made(Entry, $c759, ["kind", $c1090, true, "", "", "kind", ""]);
const $c1093 = $made(Limit, $c765, ["length", 0.0, 1000.0, true, false]);
const $c1092 = $made(Quantity, $c129, ["length", $c1093]);
const $c1086 = $made(Entry, $c759, ["length", $c1092, true, "", "length = \"2.9 m\"", "length", ""]);
const $c1095 = $made(Limit, $c765, ["angle", 0.0, 1.5707963267948966, true, false]);
const $c1094 = $made(Quantity, $c129, ["angle", $c1095]);
const $c1087 = $made(Entry, $c759, ["trough_angle", $c1094, true, "", "trough_angle = \"35 deg\"", "trough_angle", ""]);
const $c1097 = $made(Limit, $c765, ["length", 0.0, 100.0, false, false]);
const $c1096 = $made(Quantity, $c129, ["length", $c1097]);
const $c1088 = $made(Entry, $c759, ["centre_roll", $c1096, true, "", "centre_roll = \"465 mm\"", "centre_roll", ""]);
const $c1099 = ["full", "half"];
const $c1098 = $made(Choice, $c782, [$c1099]);
const $c1089 = $made(Entry, $c759, ["depth", $c1098, false, "", "", "depth", ""]);
const $c1083 = [$c1085, $c1086, $c1087, $c1088, $c1089];
const $c1084 = new Map([["kind", $c1085], ["length", $c1086], ["trough_angle", $c1087], ["centre_roll", $c1088], ["depth", $c1089]]);
const $c1074 = $made(tables$Table, $c744, [Transition, $c1083, $c1084]);
const $c1072 = new Map([["pulley", $c1073], ["transition", $c1074]]);
const $c28 = $made(Variant, $c905, ["kind", $c1072]);
const $c1071 = $made(WordOr, $c796, ["far", $c28, null]);
const $c1060 = $made(Entry, $c759, ["before", $c1071, false, "", "", "before", ""]);
const $c1107 = ["pulley"];
const $c1106 = $made(Choice, $c782, [$c1107]);
const $c1105 = $made(Entry, $c759, ["kind", $c1106, true, "", "", "kind", ""]);
const $c1103 = [$c1105, $c1078];
const $c1104 = new Map([["kind", $c1105], ["distance", $c1078]]);
const $c1102 = $made(tables$Table, $c744, [GrippingPulley, $c1103, $c1104]);
const $c1101 = new Map([["pulley", $c1102]]);
const $c29 = $made(Variant, $c905, ["kind", $c1101]);
const $c1100 = $made(WordOr, $c796, ["far", $c29, null]);
const $c1061 = $made(Entry, $c759, ["after", $c1100, false, "", "", "after", ""]);
const $c1109 = ["least", "most"];
const $c1108 = $made(Count, $c1109, [4, 128]);
const $c1062 = $made(Entry, $c759, ["strips", $c1108, false, "", "", "strips", ""]);
const $c1052 = [$c1054, $c1055, $c1056, $c1057, $c1058, $c1059, $c1060, $c1061, $c1062];
const $c1053 = new Map([["shell_profile", $c1054], ["worn_depth", $c1055], ["build_up", $c1056], ["misalignment", $c1057], ["deflection", $c1058], ["entry_profile", $c1059], ["before", $c1060], ["after", $c1061], ["strips", $c1062]]);
const $c30 = $made(tables$Table, $c744, [Across, $c1052, $c1053]);
const $c181 = $made(Entry, $c759, ["across", $c30, false, "", "", "across", ""]);
const $c205 = $made(ByName, $c767, [$c2, 200]);
const $c182 = $made(Entry, $c759, ["sources", $c205, false, "", "", "sources", ""]);
const $c9 = [$c165, $c166, $c167, $c168, $c169, $c170, $c171, $c172, $c173, $c174, $c175, $c176, $c177, $c178, $c179, $c180, $c181, $c182];
const $c799 = new Map([["name", $c165], ["diameter", $c166], ["wrap_angle", $c167], ["belt_path", $c168], ["lagging", $c169], ["condition", $c170], ["entry_tension", $c171], ["exit_tension", $c172], ["effective_tension", $c173], ["torque", $c174], ["power", $c175], ["overrun", $c176], ["recovery", $c177], ["creep_limit", $c178], ["side", $c179], ["mass", $c180], ["across", $c181], ["sources", $c182]]);
const $c31 = $made(tables$Table, $c744, [Pulley, $c9, $c799]);
const $c797 = $made(Rows, $c798, [$c31, 1, 10]);
const $c753 = $made(Entry, $c759, ["pulley", $c797, true, "", "a [[pulley]] table for each pulley", "pulley", ""]);
const $c1110 = $made(ByName, $c767, [$c821, 200]);
const $c754 = $made(Entry, $c759, ["lagging", $c1110, false, "", "", "lagging", ""]);
const $c1121 = $made(Name, $c770, [60]);
const $c1115 = $made(Entry, $c759, ["name", $c1121, true, "", "name = \"start\"", "name", ""]);
const $c1122 = $made(Text, $c762, [1000, true]);
const $c1116 = $made(Entry, $c759, ["description", $c1122, false, "", "", "description", ""]);
const $c79 = ["running", "starting", "braking"];
const $c1123 = $made(Choice, $c782, [$c79]);
const $c1117 = $made(Entry, $c759, ["kind", $c1123, false, "", "", "kind", ""]);
const $c1118 = $made(Entry, $c759, ["condition", $c190, false, "", "", "condition", ""]);
const $c1126 = [$c171, $c172, $c173, $c174, $c175];
const $c1127 = new Map([["entry_tension", $c171], ["exit_tension", $c172], ["effective_tension", $c173], ["torque", $c174], ["power", $c175]]);
const $c1125 = $made(tables$Table, $c744, [null, $c1126, $c1127]);
const $c1124 = $made(ByName, $c767, [$c1125, 200]);
const $c1119 = $made(Entry, $c759, ["pulley", $c1124, false, "", "", "pulley", ""]);
const $c1128 = $made(Elsewhere, [], []);
const $c1120 = $made(Entry, $c759, ["train", $c1128, false, "", "", "train", ""]);
const $c1113 = [$c1115, $c1116, $c1117, $c1118, $c1119, $c1120];
const $c1114 = new Map([["name", $c1115], ["description", $c1116], ["kind", $c1117], ["condition", $c1118], ["pulley", $c1119], ["train", $c1120]]);
const $c1112 = $made(tables$Table, $c744, [null, $c1113, $c1114]);
const $c1111 = $made(Rows, $c798, [$c1112, 1, 1000]);
const $c755 = $made(Entry, $c759, ["load_case", $c1111, false, "", "", "load_case", ""]);
const $c1151 = $made(Limit, $c765, ["length", 0.0, 100000.0, true, false]);
const $c1150 = $made(Quantity, $c129, ["length", $c1151]);
const $c1131 = $made(Entry, $c759, ["length", $c1150, true, "", "length = \"600 m\"", "length", ""]);
const $c1153 = $made(Limit, $c765, ["length", -5000.0, 5000.0, false, false]);
const $c1152 = $made(Quantity, $c129, ["length", $c1153]);
const $c1132 = $made(Entry, $c759, ["lift", $c1152, false, "", "", "lift", ""]);
const $c1155 = $made(Limit, $c765, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c1154 = $made(Quantity, $c129, ["mass_per_length", $c1155]);
const $c1133 = $made(Entry, $c759, ["belt_mass", $c1154, true, "", "", "belt_mass", ""]);
const $c1157 = $made(Limit, $c765, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c1156 = $made(Quantity, $c129, ["mass_per_length", $c1157]);
const $c1134 = $made(Entry, $c759, ["carry_idler_mass", $c1156, true, "", "", "carry_idler_mass", ""]);
const $c1159 = $made(Limit, $c765, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c1158 = $made(Quantity, $c129, ["mass_per_length", $c1159]);
const $c1135 = $made(Entry, $c759, ["return_idler_mass", $c1158, true, "", "", "return_idler_mass", ""]);
const $c1160 = $made(Quantity, $c129, ["mass_per_length", $c1155]);
const $c1136 = $made(Entry, $c759, ["material_mass", $c1160, false, "", "", "material_mass", ""]);
const $c1162 = $made(Limit, $c765, ["mass_flow", 0.0, 100000.0, true, false]);
const $c1161 = $made(Quantity, $c129, ["mass_flow", $c1162]);
const $c1137 = $made(Entry, $c759, ["capacity", $c1161, false, "", "", "capacity", ""]);
const $c1164 = $made(Limit, $c765, ["number", 0.005, 0.1, false, false]);
const $c1163 = $made(Quantity, $c129, ["number", $c1164]);
const $c1138 = $made(Entry, $c759, ["friction_factor", $c1163, false, "", "", "friction_factor", ""]);
const $c1166 = $made(Limit, $c765, ["number", 1.0, 10.0, false, false]);
const $c1165 = $made(Quantity, $c129, ["number", $c1166]);
const $c1139 = $made(Entry, $c759, ["length_coefficient", $c1165, false, "", "", "length_coefficient", ""]);
const $c1168 = $made(Limit, $c765, ["force", 0.0, 100000000.0, false, false]);
const $c1167 = $made(Quantity, $c129, ["force", $c1168]);
const $c1140 = $made(Entry, $c759, ["secondary_resistance", $c1167, false, "", "", "secondary_resistance", ""]);
const $c1169 = $made(Quantity, $c129, ["force", $c1168]);
const $c1141 = $made(Entry, $c759, ["special_resistance", $c1169, false, "", "", "special_resistance", ""]);
const $c1171 = $made(Limit, $c765, ["number", 0.0, 1.0, false, false]);
const $c1170 = $made(Quantity, $c129, ["number", $c1171]);
const $c1142 = $made(Entry, $c759, ["return_share", $c1170, false, "", "", "return_share", ""]);
const $c1173 = $made(Limit, $c765, ["number", 1.0, 5.0, false, false]);
const $c1172 = $made(Quantity, $c129, ["number", $c1173]);
const $c1143 = $made(Entry, $c759, ["start_factor", $c1172, false, "", "", "start_factor", ""]);
const $c1175 = $made(Limit, $c765, ["time", 0.0, 3600.0, true, false]);
const $c1174 = $made(Quantity, $c129, ["time", $c1175]);
const $c1144 = $made(Entry, $c759, ["start_time", $c1174, false, "", "", "start_time", ""]);
const $c1176 = $made(Quantity, $c129, ["time", $c1175]);
const $c1145 = $made(Entry, $c759, ["stop_time", $c1176, false, "", "", "stop_time", ""]);
const $c1178 = $made(Limit, $c765, ["force", 0.0, 100000000.0, true, false]);
const $c1177 = $made(Quantity, $c129, ["force", $c1178]);
const $c1146 = $made(Entry, $c759, ["take_up_tension", $c1177, false, "", "", "take_up_tension", ""]);
const $c1180 = $made(Limit, $c765, ["mass", 0.0, 10000000.0, true, false]);
const $c1179 = $made(Quantity, $c129, ["mass", $c1180]);
const $c1147 = $made(Entry, $c759, ["counterweight", $c1179, false, "", "", "counterweight", ""]);
const $c1182 = $made(Limit, $c765, ["length", 0.0, 100000.0, false, false]);
const $c1181 = $made(Quantity, $c129, ["length", $c1182]);
const $c1148 = $made(Entry, $c759, ["take_up_distance", $c1181, false, "", "", "take_up_distance", ""]);
const $c728 = ["head", "tail"];
const $c1183 = $made(Choice, $c782, [$c728]);
const $c1149 = $made(Entry, $c759, ["drive_at", $c1183, false, "", "", "drive_at", ""]);
const $c1129 = [$c1131, $c1132, $c1133, $c1134, $c1135, $c1136, $c1137, $c1138, $c1139, $c1140, $c1141, $c1142, $c1143, $c1144, $c1145, $c1146, $c1147, $c1148, $c1149];
const $c1130 = new Map([["length", $c1131], ["lift", $c1132], ["belt_mass", $c1133], ["carry_idler_mass", $c1134], ["return_idler_mass", $c1135], ["material_mass", $c1136], ["capacity", $c1137], ["friction_factor", $c1138], ["length_coefficient", $c1139], ["secondary_resistance", $c1140], ["special_resistance", $c1141], ["return_share", $c1142], ["start_factor", $c1143], ["start_time", $c1144], ["stop_time", $c1145], ["take_up_tension", $c1146], ["counterweight", $c1147], ["take_up_distance", $c1148], ["drive_at", $c1149]]);
const $c35 = $made(tables$Table, $c744, [Conveyor, $c1129, $c1130]);
const $c756 = $made(Entry, $c759, ["conveyor", $c35, false, "", "", "conveyor", ""]);
const $c721 = ["gravity", "winch", "fixed"];
const $c1189 = $made(Choice, $c782, [$c721]);
const $c1186 = $made(Entry, $c759, ["kind", $c1189, false, "", "", "kind", ""]);
const $c712 = $made(Limit, $c765, ["number", 0.01, 100.0, false, false]);
const $c1190 = $made(Quantity, $c129, ["number", $c712]);
const $c1187 = $made(Entry, $c759, ["sheave_ratio", $c1190, false, "", "", "sheave_ratio", ""]);
const $c1191 = $made(Name, $c770, [60]);
const $c1188 = $made(Entry, $c759, ["after", $c1191, false, "", "", "after", ""]);
const $c1184 = [$c1186, $c1187, $c1188];
const $c1185 = new Map([["kind", $c1186], ["sheave_ratio", $c1187], ["after", $c1188]]);
const $c535 = $made(tables$Table, $c744, [TakeUp, $c1184, $c1185]);
const $c531 = $made(Entry, $c759, ["take_up", $c535, false, "", "", "take_up", ""]);
const $c722 = ["CEMA", "DIN 22101", "own", "none"];
const $c1199 = $made(Choice, $c782, [$c722]);
const $c1194 = $made(Entry, $c759, ["name", $c1199, false, "", "", "name", ""]);
const $c723 = ["dry", "wet", "wet and dirty"];
const $c1200 = $made(Choice, $c782, [$c723]);
const $c1195 = $made(Entry, $c759, ["condition", $c1200, false, "", "", "condition", ""]);
const $c713 = $made(Limit, $c765, ["number", 0.01, 2.0, false, false]);
const $c1201 = $made(Quantity, $c129, ["number", $c713]);
const $c1196 = $made(Entry, $c759, ["friction", $c1201, false, "", "", "friction", ""]);
const $c714 = $made(Limit, $c765, ["number", 1.0, 10.0, false, false]);
const $c1202 = $made(Quantity, $c129, ["number", $c714]);
const $c1197 = $made(Entry, $c759, ["start_factor", $c1202, false, "", "", "start_factor", ""]);
const $c1203 = $made(Flag, [], []);
const $c1198 = $made(Entry, $c759, ["binding", $c1203, false, "", "", "binding", ""]);
const $c1192 = [$c1194, $c1195, $c1196, $c1197, $c1198];
const $c1193 = new Map([["name", $c1194], ["condition", $c1195], ["friction", $c1196], ["start_factor", $c1197], ["binding", $c1198]]);
const $c536 = $made(tables$Table, $c744, [DesignStandard, $c1192, $c1193]);
const $c532 = $made(Entry, $c759, ["design_standard", $c536, false, "", "", "standard", ""]);
const $c1210 = $made(Quantity, $c129, ["number", $c714]);
const $c1206 = $made(Entry, $c759, ["running", $c1210, false, "", "", "running", ""]);
const $c1211 = $made(Quantity, $c129, ["number", $c714]);
const $c1207 = $made(Entry, $c759, ["starting", $c1211, false, "", "", "starting", ""]);
const $c1212 = $made(Quantity, $c129, ["number", $c714]);
const $c1208 = $made(Entry, $c759, ["braking", $c1212, false, "", "", "braking", ""]);
const $c1213 = $made(Text, $c762, [500, false]);
const $c1209 = $made(Entry, $c759, ["source", $c1213, false, "", "", "source", ""]);
const $c1204 = [$c1206, $c1207, $c1208, $c1209];
const $c1205 = new Map([["running", $c1206], ["starting", $c1207], ["braking", $c1208], ["source", $c1209]]);
const $c537 = $made(tables$Table, $c744, [SafetyFactors, $c1204, $c1205]);
const $c533 = $made(Entry, $c759, ["safety_factor", $c537, false, "", "", "safety", ""]);
const $c1220 = $made(Limit, $c765, ["length", 0.0, 100.0, true, false]);
const $c1219 = $made(Quantity, $c129, ["length", $c1220]);
const $c1216 = $made(Entry, $c759, ["idler_spacing", $c1219, true, "", "idler_spacing = \"3 m\"", "spacing", ""]);
const $c1222 = $made(Limit, $c765, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c1221 = $made(Quantity, $c129, ["mass_per_length", $c1222]);
const $c1217 = $made(Entry, $c759, ["line_mass", $c1221, true, "", "line_mass = \"22 kg/m\"", "line_mass", ""]);
const $c1224 = $made(Limit, $c765, ["number", 0.0, 0.1, true, false]);
const $c1223 = $made(Quantity, $c129, ["number", $c1224]);
const $c1218 = $made(Entry, $c759, ["share", $c1223, false, "", "", "share", ""]);
const $c1214 = [$c1216, $c1217, $c1218];
const $c1215 = new Map([["idler_spacing", $c1216], ["line_mass", $c1217], ["share", $c1218]]);
const $c538 = $made(tables$Table, $c744, [Sag, $c1214, $c1215]);
const $c534 = $made(Entry, $c759, ["sag", $c538, false, "", "", "sag", ""]);
const $c1225 = $made(Elsewhere, [], []);
const $c757 = $made(Entry, $c759, ["train", $c1225, false, "", "", "train", ""]);
const $c1226 = $made(Elsewhere, [], []);
const $c758 = $made(Entry, $c759, ["motion", $c1226, false, "", "", "motion", ""]);
const $c745 = [$c747, $c748, $c749, $c750, $c751, $c752, $c753, $c754, $c755, $c756, $c531, $c532, $c533, $c534, $c757, $c758];
const $c746 = new Map([["format", $c747], ["title", $c748], ["description", $c749], ["creep_limit", $c750], ["condition", $c751], ["belt", $c752], ["pulley", $c753], ["lagging", $c754], ["load_case", $c755], ["conveyor", $c756], ["take_up", $c531], ["design_standard", $c532], ["safety_factor", $c533], ["sag", $c534], ["train", $c757], ["motion", $c758]]);
const $c0 = $made(tables$Table, $c744, [Drive, $c745, $c746]);
const $c3 = ["name", "kind", "modulus", "rating", "least_pulley_diameter", "carcass"];
const $c4 = new Map([["width", $c130], ["modulus", $c135], ["rating", $c137], ["strength", $c139], ["speed", $c141], ["momentary_factor", $c143], ["least_pulley_diameter", $c145], ["largest_wrap_pressure", $c147], ["in_plane_shear_stiffness", $c149], ["pulley_cover", $c151], ["carry_cover", $c153], ["carcass", $c155], ["thickness", $c157], ["cover_shear_modulus", $c160], ["mass", $c162]]);
const $c6 = ["pulley_cover", "carry_cover", "carcass"];
const $c7 = $made(_Nothing, [], []);
const $c10 = ["x", "y", "diameter", "turn"];
const $c231 = [10000, "m"];
const $c230 = [$c231];
const $c208 = ["mm", $c230];
const $c209 = ["kN", []];
const $c210 = ["kN/m", []];
const $c233 = [10000, "MPa"];
const $c232 = [$c233];
const $c211 = ["kPa", $c232];
const $c212 = ["kPa/mm", []];
const $c213 = ["m/s", []];
const $c214 = ["deg", []];
const $c215 = ["kW", []];
const $c216 = ["kN m", []];
const $c217 = ["m2", []];
const $c218 = ["s", []];
const $c219 = ["degC", []];
const $c220 = ["1/mm", []];
const $c221 = ["mm3/J", []];
const $c222 = ["J/m2", []];
const $c235 = [10000, "kW/m2"];
const $c234 = [$c235];
const $c223 = ["W/m2", $c234];
const $c224 = ["rpm", []];
const $c225 = ["kg", []];
const $c226 = ["kg/m", []];
const $c227 = ["t/h", []];
const $c228 = ["kg m2", []];
const $c229 = ["", []];
const $c206 = new Map([["length", $c208], ["force", $c209], ["force_per_width", $c210], ["spring_rate", $c210], ["pressure", $c211], ["pressure_per_length", $c212], ["speed", $c213], ["angle", $c214], ["power", $c215], ["torque", $c216], ["area", $c217], ["time", $c218], ["temperature", $c219], ["per_length", $c220], ["wear_coefficient", $c221], ["energy_per_area", $c222], ["power_per_area", $c223], ["rotation_speed", $c224], ["mass", $c225], ["mass_per_length", $c226], ["mass_flow", $c227], ["moment_of_inertia", $c228], ["number", $c229]]);
const $c256 = [400, "ft"];
const $c255 = [$c256];
const $c236 = ["in", $c255];
const $c237 = ["lbf", []];
const $c238 = ["PIW", []];
const $c239 = ["lbf/in", []];
const $c258 = [10000, "ksi"];
const $c257 = [$c258];
const $c240 = ["psi", $c257];
const $c241 = ["psi/in", []];
const $c242 = ["fpm", []];
const $c243 = ["hp", []];
const $c244 = ["lbf ft", []];
const $c245 = ["in2", []];
const $c246 = ["degF", []];
const $c247 = ["1/in", []];
const $c248 = ["in3/(ft lbf)", []];
const $c249 = ["ft lbf/ft2", []];
const $c250 = ["hp/ft2", []];
const $c251 = ["lbm", []];
const $c252 = ["lbm/ft", []];
const $c253 = ["lbm/h", []];
const $c254 = ["lbm ft2", []];
const $c207 = new Map([["length", $c236], ["force", $c237], ["force_per_width", $c238], ["spring_rate", $c239], ["pressure", $c240], ["pressure_per_length", $c241], ["speed", $c242], ["angle", $c214], ["power", $c243], ["torque", $c244], ["area", $c245], ["time", $c218], ["temperature", $c246], ["per_length", $c247], ["wear_coefficient", $c248], ["energy_per_area", $c249], ["power_per_area", $c250], ["rotation_speed", $c224], ["mass", $c251], ["mass_per_length", $c252], ["mass_flow", $c253], ["moment_of_inertia", $c254], ["number", $c229]]);
const $c11 = new Map([["si", $c206], ["us", $c207]]);
const $c259 = new DimensionText("m", "a length", "1200 mm");
const $c260 = new DimensionText("N", "a force", "150 kN");
const $c261 = new DimensionText("N/m", "a force per width", "12960 kN/m");
const $c262 = new DimensionText("N/m", "a spring rate", "12000 kN/m");
const $c263 = new DimensionText("Pa", "a pressure", "200 kPa");
const $c264 = new DimensionText("Pa/m", "a pressure per length", "190 kPa/mm");
const $c265 = new DimensionText("m/s", "a speed", "3 m/s");
const $c266 = new DimensionText("rad", "an angle", "180 deg");
const $c267 = new DimensionText("W", "a power", "250 kW");
const $c268 = new DimensionText("N m", "a torque", "40 kN m");
const $c269 = new DimensionText("m2", "an area", "2500 mm2");
const $c270 = new DimensionText("s", "a time", "10 s");
const $c271 = new DimensionText("K", "a temperature", "20 degC");
const $c272 = new DimensionText("1/m", "a value per length", "-0.016 1/mm");
const $c273 = new DimensionText("m3/J", "a wear volume per energy", "0.05 mm3/J");
const $c274 = new DimensionText("J/m2", "an energy per area", "800 J/m2");
const $c275 = new DimensionText("W/m2", "a power per area", "1500 W/m2");
const $c276 = new DimensionText("rad/s", "a rotation speed", "71.6 rpm");
const $c277 = new DimensionText("kg", "a mass", "500 kg");
const $c278 = new DimensionText("kg/m", "a mass per length", "22 kg/m");
const $c279 = new DimensionText("kg/s", "a mass flow", "1500 t/h");
const $c280 = new DimensionText("kg m2", "a moment of inertia", "2200 kg m2");
const $c281 = new DimensionText("", "a plain number", "0.35");
const $c12 = new Map([["length", $c259], ["force", $c260], ["force_per_width", $c261], ["spring_rate", $c262], ["pressure", $c263], ["pressure_per_length", $c264], ["speed", $c265], ["angle", $c266], ["power", $c267], ["torque", $c268], ["area", $c269], ["time", $c270], ["temperature", $c271], ["per_length", $c272], ["wear_coefficient", $c273], ["energy_per_area", $c274], ["power_per_area", $c275], ["rotation_speed", $c276], ["mass", $c277], ["mass_per_length", $c278], ["mass_flow", $c279], ["moment_of_inertia", $c280], ["number", $c281]]);
const $c13 = $re("[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?", "");
const $c14 = $re("[0-9.,'’_´`\\s+\\-−/:;]*(?:(?<=[0-9])[eE][+-]?[0-9]+)?", "");
const $c15 = $re("[+-]?\\s*(?:nan|inf|infinity|∞)\\b", "i");
const $c16 = $re("[eE][+-]?([0-9]+)$", "");
const $c17 = $re("(?<=[0-9])[\\s'’_´`]+(?=[0-9])", "");
const $c18 = $re("[,.]", "");
const $c19 = $re("1\\s*/\\s*[A-Za-z(]", "");
const $c20 = $re("[0-9.,'’_´`+\\-−:;]|/\\s*[0-9]", "");
const $c21 = ["kg", "m", "s", "K", "rad"];
const $c344 = ["meter", "meters", "metre", "metres"];
const $c345 = $Decimal.of("1");
const $c346 = $Decimal.of("0");
const $c282 = new Definition($c344, $c345, "m", $c346);
const $c347 = ["km"];
const $c348 = $Decimal.of("1000");
const $c349 = $Decimal.of("0");
const $c283 = new Definition($c347, $c348, "m", $c349);
const $c350 = ["dm"];
const $c351 = $Decimal.of("0.1");
const $c352 = $Decimal.of("0");
const $c284 = new Definition($c350, $c351, "m", $c352);
const $c353 = ["cm"];
const $c354 = $Decimal.of("0.01");
const $c355 = $Decimal.of("0");
const $c285 = new Definition($c353, $c354, "m", $c355);
const $c356 = ["mm"];
const $c357 = $Decimal.of("0.001");
const $c358 = $Decimal.of("0");
const $c286 = new Definition($c356, $c357, "m", $c358);
const $c359 = ["um", "micron", "microns"];
const $c360 = $Decimal.of("0.000001");
const $c361 = $Decimal.of("0");
const $c287 = new Definition($c359, $c360, "m", $c361);
const $c362 = ["in", "inch", "inches", "\""];
const $c363 = $Decimal.of("0.0254");
const $c364 = $Decimal.of("0");
const $c288 = new Definition($c362, $c363, "m", $c364);
const $c365 = ["ft", "foot", "feet"];
const $c366 = $Decimal.of("12");
const $c367 = $Decimal.of("0");
const $c289 = new Definition($c365, $c366, "in", $c367);
const $c368 = ["yd"];
const $c369 = $Decimal.of("3");
const $c370 = $Decimal.of("0");
const $c290 = new Definition($c368, $c369, "ft", $c370);
const $c371 = ["mi", "mile", "miles"];
const $c372 = $Decimal.of("5280");
const $c373 = $Decimal.of("0");
const $c291 = new Definition($c371, $c372, "ft", $c373);
const $c374 = ["thou"];
const $c375 = $Decimal.of("0.001");
const $c376 = $Decimal.of("0");
const $c292 = new Definition($c374, $c375, "in", $c376);
const $c377 = ["g"];
const $c378 = $Decimal.of("0.001");
const $c379 = $Decimal.of("0");
const $c293 = new Definition($c377, $c378, "kg", $c379);
const $c380 = ["t", "tonne", "tonnes"];
const $c381 = $Decimal.of("1000");
const $c382 = $Decimal.of("0");
const $c294 = new Definition($c380, $c381, "kg", $c382);
const $c383 = ["lbm"];
const $c384 = $Decimal.of("0.45359237");
const $c385 = $Decimal.of("0");
const $c295 = new Definition($c383, $c384, "kg", $c385);
const $c386 = ["sec", "second", "seconds"];
const $c387 = $Decimal.of("1");
const $c388 = $Decimal.of("0");
const $c296 = new Definition($c386, $c387, "s", $c388);
const $c389 = ["ms"];
const $c390 = $Decimal.of("0.001");
const $c391 = $Decimal.of("0");
const $c297 = new Definition($c389, $c390, "s", $c391);
const $c392 = ["min", "minute", "minutes"];
const $c393 = $Decimal.of("60");
const $c394 = $Decimal.of("0");
const $c298 = new Definition($c392, $c393, "s", $c394);
const $c395 = ["h", "hr", "hour", "hours"];
const $c396 = $Decimal.of("60");
const $c397 = $Decimal.of("0");
const $c299 = new Definition($c395, $c396, "min", $c397);
const $c398 = ["d", "day", "days"];
const $c399 = $Decimal.of("24");
const $c400 = $Decimal.of("0");
const $c300 = new Definition($c398, $c399, "h", $c400);
const $c401 = ["N", "newton", "newtons"];
const $c402 = $Decimal.of("1");
const $c403 = $Decimal.of("0");
const $c301 = new Definition($c401, $c402, "kg m/s2", $c403);
const $c404 = ["mN"];
const $c405 = $Decimal.of("0.001");
const $c406 = $Decimal.of("0");
const $c302 = new Definition($c404, $c405, "N", $c406);
const $c407 = ["daN"];
const $c408 = $Decimal.of("10");
const $c409 = $Decimal.of("0");
const $c303 = new Definition($c407, $c408, "N", $c409);
const $c410 = ["kN"];
const $c411 = $Decimal.of("1000");
const $c412 = $Decimal.of("0");
const $c304 = new Definition($c410, $c411, "N", $c412);
const $c413 = ["MN"];
const $c414 = $Decimal.of("1E+6");
const $c415 = $Decimal.of("0");
const $c305 = new Definition($c413, $c414, "N", $c415);
const $c416 = ["kgf", "kp"];
const $c417 = $Decimal.of("9.80665");
const $c418 = $Decimal.of("0");
const $c306 = new Definition($c416, $c417, "N", $c418);
const $c419 = ["gf"];
const $c420 = $Decimal.of("0.001");
const $c421 = $Decimal.of("0");
const $c307 = new Definition($c419, $c420, "kgf", $c421);
const $c422 = ["tf"];
const $c423 = $Decimal.of("1000");
const $c424 = $Decimal.of("0");
const $c308 = new Definition($c422, $c423, "kgf", $c424);
const $c425 = ["lbf", "lb", "lbs"];
const $c426 = $Decimal.of("4.4482216152605");
const $c427 = $Decimal.of("0");
const $c309 = new Definition($c425, $c426, "N", $c427);
const $c428 = ["klbf", "kip", "kips"];
const $c429 = $Decimal.of("1000");
const $c430 = $Decimal.of("0");
const $c310 = new Definition($c428, $c429, "lbf", $c430);
const $c431 = ["PIW", "piw", "PLI", "pli"];
const $c432 = $Decimal.of("1");
const $c433 = $Decimal.of("0");
const $c311 = new Definition($c431, $c432, "lbf/in", $c433);
const $c434 = ["Pa"];
const $c435 = $Decimal.of("1");
const $c436 = $Decimal.of("0");
const $c312 = new Definition($c434, $c435, "N/m2", $c436);
const $c437 = ["hPa"];
const $c438 = $Decimal.of("100");
const $c439 = $Decimal.of("0");
const $c313 = new Definition($c437, $c438, "Pa", $c439);
const $c440 = ["kPa"];
const $c441 = $Decimal.of("1000");
const $c442 = $Decimal.of("0");
const $c314 = new Definition($c440, $c441, "Pa", $c442);
const $c443 = ["MPa"];
const $c444 = $Decimal.of("1E+6");
const $c445 = $Decimal.of("0");
const $c315 = new Definition($c443, $c444, "Pa", $c445);
const $c446 = ["GPa"];
const $c447 = $Decimal.of("1E+9");
const $c448 = $Decimal.of("0");
const $c316 = new Definition($c446, $c447, "Pa", $c448);
const $c449 = ["bar"];
const $c450 = $Decimal.of("1E+5");
const $c451 = $Decimal.of("0");
const $c317 = new Definition($c449, $c450, "Pa", $c451);
const $c452 = ["mbar"];
const $c453 = $Decimal.of("100");
const $c454 = $Decimal.of("0");
const $c318 = new Definition($c452, $c453, "Pa", $c454);
const $c455 = ["psi", "PSI"];
const $c456 = $Decimal.of("1");
const $c457 = $Decimal.of("0");
const $c319 = new Definition($c455, $c456, "lbf/in2", $c457);
const $c458 = ["ksi"];
const $c459 = $Decimal.of("1000");
const $c460 = $Decimal.of("0");
const $c320 = new Definition($c458, $c459, "psi", $c460);
const $c461 = ["J", "joule"];
const $c462 = $Decimal.of("1");
const $c463 = $Decimal.of("0");
const $c321 = new Definition($c461, $c462, "N m", $c463);
const $c464 = ["mJ"];
const $c465 = $Decimal.of("0.001");
const $c466 = $Decimal.of("0");
const $c322 = new Definition($c464, $c465, "J", $c466);
const $c467 = ["kJ"];
const $c468 = $Decimal.of("1000");
const $c469 = $Decimal.of("0");
const $c323 = new Definition($c467, $c468, "J", $c469);
const $c470 = ["MJ"];
const $c471 = $Decimal.of("1E+6");
const $c472 = $Decimal.of("0");
const $c324 = new Definition($c470, $c471, "J", $c472);
const $c473 = ["Nm"];
const $c474 = $Decimal.of("1");
const $c475 = $Decimal.of("0");
const $c325 = new Definition($c473, $c474, "N m", $c475);
const $c476 = ["kNm"];
const $c477 = $Decimal.of("1000");
const $c478 = $Decimal.of("0");
const $c326 = new Definition($c476, $c477, "N m", $c478);
const $c479 = ["MNm"];
const $c480 = $Decimal.of("1E+6");
const $c481 = $Decimal.of("0");
const $c327 = new Definition($c479, $c480, "N m", $c481);
const $c482 = ["W", "watt", "watts"];
const $c483 = $Decimal.of("1");
const $c484 = $Decimal.of("0");
const $c328 = new Definition($c482, $c483, "J/s", $c484);
const $c485 = ["kW"];
const $c486 = $Decimal.of("1000");
const $c487 = $Decimal.of("0");
const $c329 = new Definition($c485, $c486, "W", $c487);
const $c488 = ["MW"];
const $c489 = $Decimal.of("1E+6");
const $c490 = $Decimal.of("0");
const $c330 = new Definition($c488, $c489, "W", $c490);
const $c491 = ["hp", "HP", "bhp", "BHP"];
const $c492 = $Decimal.of("550");
const $c493 = $Decimal.of("0");
const $c331 = new Definition($c491, $c492, "ft lbf/s", $c493);
const $c494 = ["PS", "cv", "CV", "hp(metric)"];
const $c495 = $Decimal.of("75");
const $c496 = $Decimal.of("0");
const $c332 = new Definition($c494, $c495, "kgf m/s", $c496);
const $c497 = ["fpm", "FPM"];
const $c498 = $Decimal.of("1");
const $c499 = $Decimal.of("0");
const $c333 = new Definition($c497, $c498, "ft/min", $c499);
const $c500 = ["fps"];
const $c501 = $Decimal.of("1");
const $c502 = $Decimal.of("0");
const $c334 = new Definition($c500, $c501, "ft/s", $c502);
const $c503 = ["kph", "kmh"];
const $c504 = $Decimal.of("1");
const $c505 = $Decimal.of("0");
const $c335 = new Definition($c503, $c504, "km/h", $c505);
const $c506 = ["mph"];
const $c507 = $Decimal.of("1");
const $c508 = $Decimal.of("0");
const $c336 = new Definition($c506, $c507, "mi/h", $c508);
const $c509 = ["mrad"];
const $c510 = $Decimal.of("0.001");
const $c511 = $Decimal.of("0");
const $c337 = new Definition($c509, $c510, "rad", $c511);
const $c512 = ["deg", "degree", "degrees", "°"];
const $c513 = $Decimal.of("0.01745329251994329576923690768");
const $c514 = $Decimal.of("0");
const $c338 = new Definition($c512, $c513, "rad", $c514);
const $c515 = ["rev", "turn", "turns"];
const $c516 = $Decimal.of("360");
const $c517 = $Decimal.of("0");
const $c339 = new Definition($c515, $c516, "deg", $c517);
const $c518 = ["rpm", "RPM"];
const $c519 = $Decimal.of("1");
const $c520 = $Decimal.of("0");
const $c340 = new Definition($c518, $c519, "rev/min", $c520);
const $c521 = ["degC", "°C"];
const $c522 = $Decimal.of("1");
const $c523 = $Decimal.of("-273.15");
const $c341 = new Definition($c521, $c522, "K", $c523);
const $c524 = ["degF", "°F"];
const $c525 = $Decimal.of("0.5555555555555555555555555556");
const $c526 = $Decimal.of("-459.67");
const $c342 = new Definition($c524, $c525, "K", $c526);
const $c527 = ["%", "percent"];
const $c528 = $Decimal.of("0.01");
const $c529 = $Decimal.of("0");
const $c343 = new Definition($c527, $c528, "", $c529);
const $c22 = [$c282, $c283, $c284, $c285, $c286, $c287, $c288, $c289, $c290, $c291, $c292, $c293, $c294, $c295, $c296, $c297, $c298, $c299, $c300, $c301, $c302, $c303, $c304, $c305, $c306, $c307, $c308, $c309, $c310, $c311, $c312, $c313, $c314, $c315, $c316, $c317, $c318, $c319, $c320, $c321, $c322, $c323, $c324, $c325, $c326, $c327, $c328, $c329, $c330, $c331, $c332, $c333, $c334, $c335, $c336, $c337, $c338, $c339, $c340, $c341, $c342, $c343];
const $c23 = new Map([[181, "u"], [956, "u"], [8243, "\""], [8221, "\""], [186, "°"], [183, "*"], [8901, "*"], [215, "*"], [178, "2"], [179, "3"], [8315, "-"], [185, "1"], [160, " "], [8239, " "]]);
const $c24 = $re("(?<over>1|[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)?\\s*(?:/\\s*(?:(?<one>[A-Za-z°%\"]+(?:\\^?-?[1-9])?)|\\(\\s*(?<under>[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)\\s*\\)))?", "");
const $c25 = $re("([A-Za-z°%\"]+)(?:\\^?(-?[1-9]))?", "");
const $c26 = ["length", "force", "force_per_width", "spring_rate", "pressure", "pressure_per_length", "speed", "angle", "power", "torque", "area", "time", "temperature", "per_length", "wear_coefficient", "energy_per_area", "power_per_area", "rotation_speed", "mass", "mass_per_length", "mass_flow", "moment_of_inertia", "number"];
const $c530 = ["kind", "source", "date", "note"];
const $c27 = $made(Provenance, $c530, ["given", "", "", "from the coordinates of the pulleys"]);
const $c32 = [$c531, $c532, $c533, $c534];
const $c33 = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
const $c34 = new Map([["entry", "entry_tension"], ["exit", "exit_tension"]]);
const $c539 = ["material_mass", "capacity", "material_mass = \"120 kg/m\""];
const $c540 = ["take_up_tension", "counterweight", "take_up_tension = \"40 kN\""];
const $c541 = ["length_coefficient", "secondary_resistance", ""];
const $c542 = ["start_factor", "start_time", ""];
const $c36 = [$c539, $c540, $c541, $c542];
const $c37 = ["capacity", "start_time", "stop_time"];
const $c1246 = $made(Quantity, $c129, ["force", $c192]);
const $c1239 = $made(Entry, $c759, ["entry_tension", $c1246, false, "", "", "entry_tension", ""]);
const $c1240 = $made(Entry, $c759, ["exit_tension", $c1246, false, "", "", "exit_tension", ""]);
const $c1247 = $made(Quantity, $c129, ["force", null]);
const $c1241 = $made(Entry, $c759, ["effective_tension", $c1247, false, "", "", "effective_tension", ""]);
const $c1248 = $made(Quantity, $c129, ["power", null]);
const $c1242 = $made(Entry, $c759, ["power", $c1248, false, "", "", "power", ""]);
const $c1250 = $made(Quantity, $c129, ["force", null]);
const $c1249 = $made(ByName, $c767, [$c1250, 200]);
const $c1243 = $made(Entry, $c759, ["run", $c1249, false, "", "", "run", ""]);
const $c1473 = ["first", "second", "words"];
const $c1476 = $made(Limit, $c765, ["number", -100.0, 100.0, false, false]);
const $c1474 = $made(Quantity, $c129, ["number", $c1476]);
const $c1475 = $made(Quantity, $c129, ["power", null]);
const $c1252 = $made(Either, $c1473, [$c1474, $c1475, "a share like 0.5 or \"50 %\", or a power like \"300 kW\""]);
const $c1251 = $made(Rows, $c798, [$c1252, 1, 10]);
const $c1244 = $made(Entry, $c759, ["share", $c1251, false, "", "", "share", ""]);
const $c1253 = $made(SpeedList, [], []);
const $c1245 = $made(Entry, $c759, ["speeds", $c1253, false, "", "", "speeds", ""]);
const $c1237 = [$c1239, $c1240, $c1241, $c1242, $c1243, $c1244, $c1245];
const $c1238 = new Map([["entry_tension", $c1239], ["exit_tension", $c1240], ["effective_tension", $c1241], ["power", $c1242], ["run", $c1243], ["share", $c1244], ["speeds", $c1245]]);
const $c1236 = $made(tables$Table, $c744, [null, $c1237, $c1238]);
const $c1235 = $made(Entry, $c759, ["train", $c1236, false, "", "", "train", ""]);
const $c1233 = [$c1115, $c1116, $c1117, $c1118, $c1119, $c1235];
const $c1234 = new Map([["name", $c1115], ["description", $c1116], ["kind", $c1117], ["condition", $c1118], ["pulley", $c1119], ["train", $c1235]]);
const $c1232 = $made(tables$Table, $c744, [null, $c1233, $c1234]);
const $c1231 = $made(Rows, $c798, [$c1232, 1, 1000]);
const $c1229 = $made(Entry, $c759, ["load_case", $c1231, false, "", "", "load_case", ""]);
const $c1260 = $made(Quantity, $c129, ["length", $c185]);
const $c1259 = $made(Rows, $c798, [$c1260, 1, 10]);
const $c1257 = $made(Entry, $c759, ["diameters", $c1259, false, "", "", "diameters", ""]);
const $c1276 = ["converter"];
const $c1275 = $made(Choice, $c782, [$c1276]);
const $c1264 = $made(Entry, $c759, ["kind", $c1275, true, "", "", "kind", ""]);
const $c697 = $made(Limit, $c765, ["power", 0.0, 1000000000.0, true, false]);
const $c1277 = $made(Quantity, $c129, ["power", $c697]);
const $c1265 = $made(Entry, $c759, ["rated_power", $c1277, true, "", "", "rated_power", ""]);
const $c698 = $made(Limit, $c765, ["rotation_speed", 0.0, 100000.0, true, false]);
const $c1278 = $made(Quantity, $c129, ["rotation_speed", $c698]);
const $c1266 = $made(Entry, $c759, ["rated_speed", $c1278, true, "", "", "rated_speed", ""]);
const $c699 = $made(Limit, $c765, ["number", 0.0, 10000.0, true, false]);
const $c1279 = $made(Quantity, $c129, ["number", $c699]);
const $c1267 = $made(Entry, $c759, ["gear_ratio", $c1279, false, "", "", "gear_ratio", ""]);
const $c700 = $made(Limit, $c765, ["number", 0.05, 1.0, false, false]);
const $c1280 = $made(Quantity, $c129, ["number", $c700]);
const $c1268 = $made(Entry, $c759, ["gear_efficiency", $c1280, false, "", "", "gear_efficiency", ""]);
const $c701 = $made(Limit, $c765, ["number", 0.05, 1.0, false, false]);
const $c1281 = $made(Quantity, $c129, ["number", $c701]);
const $c1269 = $made(Entry, $c759, ["motor_efficiency", $c1281, false, "", "", "motor_efficiency", ""]);
const $c1282 = $made(Count, $c1109, [1, 8]);
const $c1270 = $made(Entry, $c759, ["count", $c1282, false, "", "", "count", ""]);
const $c1283 = $made(Flag, [], []);
const $c1271 = $made(Entry, $c759, ["brakes", $c1283, false, "", "", "brakes", ""]);
const $c1285 = $made(Limit, $c765, ["number", 0.01, 3.0, false, false]);
const $c1284 = $made(Quantity, $c129, ["number", $c1285]);
const $c1272 = $made(Entry, $c759, ["setting", $c1284, false, "", "", "setting", ""]);
const $c1287 = $made(Limit, $c765, ["number", 0.0, 0.5, false, false]);
const $c1286 = $made(Quantity, $c129, ["number", $c1287]);
const $c1273 = $made(Entry, $c759, ["droop", $c1286, false, "", "", "droop", ""]);
const $c1290 = $made(Limit, $c765, ["number", 0.0, Infinity, true, true]);
const $c1289 = $made(Quantity, $c129, ["number", $c1290]);
const $c1288 = $made(WordOr, $c796, ["rigid", $c1289, Infinity]);
const $c1274 = $made(Entry, $c759, ["torque_limit", $c1288, false, "", "", "torque_limit", ""]);
const $c1262 = [$c1264, $c1265, $c1266, $c1267, $c1268, $c1269, $c1270, $c1271, $c1272, $c1273, $c1274];
const $c1263 = new Map([["kind", $c1264], ["rated_power", $c1265], ["rated_speed", $c1266], ["gear_ratio", $c1267], ["gear_efficiency", $c1268], ["motor_efficiency", $c1269], ["count", $c1270], ["brakes", $c1271], ["setting", $c1272], ["droop", $c1273], ["torque_limit", $c1274]]);
const $c684 = $made(tables$Table, $c744, [VariableSpeed, $c1262, $c1263]);
const $c1303 = ["induction"];
const $c1302 = $made(Choice, $c782, [$c1303]);
const $c1293 = $made(Entry, $c759, ["kind", $c1302, true, "", "", "kind", ""]);
const $c1304 = $made(Quantity, $c129, ["power", $c697]);
const $c1294 = $made(Entry, $c759, ["rated_power", $c1304, true, "", "", "rated_power", ""]);
const $c1305 = $made(Quantity, $c129, ["rotation_speed", $c698]);
const $c1295 = $made(Entry, $c759, ["rated_speed", $c1305, true, "", "", "rated_speed", ""]);
const $c1306 = $made(Quantity, $c129, ["number", $c699]);
const $c1296 = $made(Entry, $c759, ["gear_ratio", $c1306, false, "", "", "gear_ratio", ""]);
const $c1307 = $made(Quantity, $c129, ["number", $c700]);
const $c1297 = $made(Entry, $c759, ["gear_efficiency", $c1307, false, "", "", "gear_efficiency", ""]);
const $c1308 = $made(Quantity, $c129, ["number", $c701]);
const $c1298 = $made(Entry, $c759, ["motor_efficiency", $c1308, false, "", "", "motor_efficiency", ""]);
const $c1309 = $made(Flag, [], []);
const $c1299 = $made(Entry, $c759, ["brakes", $c1309, false, "", "", "brakes", ""]);
const $c1311 = $made(Limit, $c765, ["rotation_speed", 0.0, 100000.0, true, false]);
const $c1310 = $made(Quantity, $c129, ["rotation_speed", $c1311]);
const $c1300 = $made(Entry, $c759, ["synchronous_speed", $c1310, true, "", "", "synchronous_speed", ""]);
const $c1313 = $made(Limit, $c765, ["number", 1.1, 10.0, false, false]);
const $c1312 = $made(Quantity, $c129, ["number", $c1313]);
const $c1301 = $made(Entry, $c759, ["breakdown_ratio", $c1312, false, "", "", "breakdown_ratio", ""]);
const $c1291 = [$c1293, $c1294, $c1295, $c1296, $c1297, $c1298, $c1270, $c1299, $c1300, $c1301];
const $c1292 = new Map([["kind", $c1293], ["rated_power", $c1294], ["rated_speed", $c1295], ["gear_ratio", $c1296], ["gear_efficiency", $c1297], ["motor_efficiency", $c1298], ["count", $c1270], ["brakes", $c1299], ["synchronous_speed", $c1300], ["breakdown_ratio", $c1301]]);
const $c685 = $made(tables$Table, $c744, [Induction, $c1291, $c1292]);
const $c1328 = ["fluid-coupling"];
const $c1327 = $made(Choice, $c782, [$c1328]);
const $c1316 = $made(Entry, $c759, ["kind", $c1327, true, "", "", "kind", ""]);
const $c1329 = $made(Quantity, $c129, ["power", $c697]);
const $c1317 = $made(Entry, $c759, ["rated_power", $c1329, true, "", "", "rated_power", ""]);
const $c1330 = $made(Quantity, $c129, ["rotation_speed", $c698]);
const $c1318 = $made(Entry, $c759, ["rated_speed", $c1330, true, "", "", "rated_speed", ""]);
const $c1331 = $made(Quantity, $c129, ["number", $c699]);
const $c1319 = $made(Entry, $c759, ["gear_ratio", $c1331, false, "", "", "gear_ratio", ""]);
const $c1332 = $made(Quantity, $c129, ["number", $c700]);
const $c1320 = $made(Entry, $c759, ["gear_efficiency", $c1332, false, "", "", "gear_efficiency", ""]);
const $c1333 = $made(Quantity, $c129, ["number", $c701]);
const $c1321 = $made(Entry, $c759, ["motor_efficiency", $c1333, false, "", "", "motor_efficiency", ""]);
const $c1334 = $made(Flag, [], []);
const $c1322 = $made(Entry, $c759, ["brakes", $c1334, false, "", "", "brakes", ""]);
const $c1335 = $made(Quantity, $c129, ["rotation_speed", $c1311]);
const $c1323 = $made(Entry, $c759, ["synchronous_speed", $c1335, true, "", "", "synchronous_speed", ""]);
const $c1336 = $made(Quantity, $c129, ["number", $c1313]);
const $c1324 = $made(Entry, $c759, ["breakdown_ratio", $c1336, false, "", "", "breakdown_ratio", ""]);
const $c1339 = $made(Limit, $c765, ["number", 0.0, 10.0, false, false]);
const $c1338 = $made(Quantity, $c129, ["number", $c1339]);
const $c1337 = $made(Rows, $c798, [$c1338, 2, 200]);
const $c1325 = $made(Entry, $c759, ["coupling_load", $c1337, true, "", "", "coupling_load", ""]);
const $c1326 = $made(Entry, $c759, ["coupling_slip", $c1337, true, "", "", "coupling_slip", ""]);
const $c1314 = [$c1316, $c1317, $c1318, $c1319, $c1320, $c1321, $c1270, $c1322, $c1323, $c1324, $c1325, $c1326];
const $c1315 = new Map([["kind", $c1316], ["rated_power", $c1317], ["rated_speed", $c1318], ["gear_ratio", $c1319], ["gear_efficiency", $c1320], ["motor_efficiency", $c1321], ["count", $c1270], ["brakes", $c1322], ["synchronous_speed", $c1323], ["breakdown_ratio", $c1324], ["coupling_load", $c1325], ["coupling_slip", $c1326]]);
const $c686 = $made(tables$Table, $c744, [FluidCoupling, $c1314, $c1315]);
const $c1346 = ["follower"];
const $c1345 = $made(Choice, $c782, [$c1346]);
const $c1342 = $made(Entry, $c759, ["kind", $c1345, true, "", "", "kind", ""]);
const $c1347 = $made(Name, $c770, [60]);
const $c1343 = $made(Entry, $c759, ["master", $c1347, true, "", "", "master", ""]);
const $c711 = $made(Limit, $c765, ["number", -10.0, 10.0, false, false]);
const $c1348 = $made(Quantity, $c129, ["number", $c711]);
const $c1344 = $made(Entry, $c759, ["ratio", $c1348, false, "", "", "ratio", ""]);
const $c1340 = [$c1342, $c1343, $c1344];
const $c1341 = new Map([["kind", $c1342], ["master", $c1343], ["ratio", $c1344]]);
const $c687 = $made(tables$Table, $c744, [TorqueFollower, $c1340, $c1341]);
const $c82 = new Map([["converter", $c684], ["induction", $c685], ["fluid-coupling", $c686], ["follower", $c687]]);
const $c83 = $made(Variant, $c905, ["kind", $c82]);
const $c1261 = $made(ByName, $c767, [$c83, 200]);
const $c1258 = $made(Entry, $c759, ["motor", $c1261, false, "", "", "motor", ""]);
const $c1255 = [$c1239, $c1240, $c1241, $c1242, $c1243, $c1244, $c1245, $c1257, $c1258];
const $c1256 = new Map([["entry_tension", $c1239], ["exit_tension", $c1240], ["effective_tension", $c1241], ["power", $c1242], ["run", $c1243], ["share", $c1244], ["speeds", $c1245], ["diameters", $c1257], ["motor", $c1258]]);
const $c1254 = $made(tables$Table, $c744, [null, $c1255, $c1256]);
const $c1230 = $made(Entry, $c759, ["train", $c1254, false, "", "", "train", ""]);
const $c1227 = [$c747, $c748, $c749, $c750, $c751, $c752, $c753, $c754, $c1229, $c756, $c531, $c532, $c533, $c534, $c1230, $c758];
const $c1228 = new Map([["format", $c747], ["title", $c748], ["description", $c749], ["creep_limit", $c750], ["condition", $c751], ["belt", $c752], ["pulley", $c753], ["lagging", $c754], ["load_case", $c1229], ["conveyor", $c756], ["take_up", $c531], ["design_standard", $c532], ["safety_factor", $c533], ["sag", $c534], ["train", $c1230], ["motion", $c758]]);
const $c38 = $made(tables$Table, $c744, [Drive, $c1227, $c1228]);
const $c39 = $re("[A-Za-z0-9_-]{1,60}", "");
const $c40 = new Map([["The pulley carries its load.", true], ["Breakaway: no creep makes enough friction for this tension ratio. Raise the slack-side tension (take-up), enlarge the wrap angle, or choose a lagging with more friction.", false], ["The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.", false], ["The drives carry the load.", true], ["Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", false], ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", false], ["The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.", false]]);
const $c41 = new Map([["illustrative", "illustrative: it describes no real product"], ["calibrated", "calibrated: it was fitted to a known result"]]);
const $c42 = ["illustrative", "calibrated", "estimated"];
const $c543 = [0.2, 4.0];
const $c544 = [100000.0, 1000000000.0];
const $c545 = [0.05, 15.0];
const $c546 = [0.15, 3.0];
const $c547 = [0.17453292519943295, 4.71238898038469];
const $c548 = [2.0943951023931953, 4.71238898038469];
const $c549 = [5e-05, 0.061];
const $c550 = [-0.002, 0.002];
const $c551 = [0.0, 0.06];
const $c552 = [100000.0, 50000000.0];
const $c553 = [100000.0, 5000000000.0];
const $c554 = [5000.0, 2000000.0];
const $c555 = [10000.0, 50000000.0];
const $c556 = [50000.0, 10000000.0];
const $c557 = [0.1, 3.0];
const $c558 = [500.0, 10000000.0];
const $c559 = [15.0, 1000.0];
const $c560 = [3.0, 20.0];
const $c561 = [0.0, 1600000.0];
const $c562 = [250.0, 20000000.0];
const $c563 = [1.0, 130.0];
const $c43 = [$c543, $c544, $c545, $c546, $c547, $c548, $c549, $c550, $c551, $c552, $c553, $c554, $c555, $c555, $c556, $c557, $c558, $c559, $c560, $c561, $c558, $c558, $c562, $c563];
const $c44 = ["force", "mass_per_length"];
const $c564 = ["mm", "m", "cm", "in", "ft"];
const $c565 = ["kN", "N", "lbf", "kgf", "tf", "MN"];
const $c566 = ["kN/m", "N/m", "PIW", "N/mm", "MN/m"];
const $c567 = ["kPa", "MPa", "Pa", "psi", "bar", "GPa"];
const $c568 = ["m/s", "m/min", "ft/min", "km/h"];
const $c569 = ["deg", "rad"];
const $c570 = ["kW", "W", "hp", "MW"];
const $c571 = ["t", "kg", "g"];
const $c572 = ["kg/m", "g/m", "t/m"];
const $c573 = ["t/h", "kg/s", "kg/h"];
const $c574 = ["kg m2", "t m2", "kg cm2"];
const $c575 = ["kN m", "N m", "MN m"];
const $c576 = ["s", "min", "ms", "h"];
const $c45 = new Map([["length", $c564], ["force", $c565], ["force_per_width", $c566], ["pressure", $c567], ["speed", $c568], ["angle", $c569], ["power", $c570], ["mass", $c571], ["mass_per_length", $c572], ["mass_flow", $c573], ["moment_of_inertia", $c574], ["torque", $c575], ["time", $c576]]);
const $c603 = ["name", "what", "missed", "at_most", "fails_beyond", "tolerates"];
const $c577 = $made(Rule, $c603, ["gross_slip", "the safety against gross slip", "ATTENTION", false, 1.0, NaN]);
const $c578 = $made(Rule, $c603, ["design_standard", "the design standard", "ATTENTION", false, NaN, NaN]);
const $c579 = $made(Rule, $c603, ["creep", "the creep limit", "ATTENTION", true, 0.0635, 0.0127]);
const $c580 = $made(Rule, $c603, ["cover_creep", "the creep limit, with the cover of the belt in series", "ATTENTION", true, NaN, NaN]);
const $c581 = $made(Rule, $c603, ["creep_interval", "the creep limit, at the end of the interval of the law", "ATTENTION", true, NaN, NaN]);
const $c582 = $made(Rule, $c603, ["belt_tension", "the rating of the belt", "FAILS", true, NaN, NaN]);
const $c583 = $made(Rule, $c603, ["momentary_tension", "the momentary rating of the belt", "FAILS", true, NaN, NaN]);
const $c584 = $made(Rule, $c603, ["belt_safety", "the safety factor of the belt", "ATTENTION", false, 3.0, NaN]);
const $c585 = $made(Rule, $c603, ["face_pressure", "the pressure on the pulley face", "ATTENTION", true, NaN, NaN]);
const $c586 = $made(Rule, $c603, ["bond_stress", "the bond strength of the lagging", "ATTENTION", true, NaN, NaN]);
const $c587 = $made(Rule, $c603, ["fatigue_stress", "the fatigue limit of the lagging", "ATTENTION", true, NaN, NaN]);
const $c588 = $made(Rule, $c603, ["tested_pressure_max", "the largest wrap pressure tested", "ATTENTION", true, NaN, NaN]);
const $c589 = $made(Rule, $c603, ["tested_pressure_min", "the least wrap pressure tested", "ATTENTION", false, NaN, NaN]);
const $c590 = $made(Rule, $c603, ["condition", "friction that was not tested in the condition", "ATTENTION", true, NaN, NaN]);
const $c591 = $made(Rule, $c603, ["fit", "friction that does not fit its tests", "ATTENTION", true, NaN, NaN]);
const $c592 = $made(Rule, $c603, ["tested_slip", "the largest slip tested", "ATTENTION", true, NaN, NaN]);
const $c593 = $made(Rule, $c603, ["tested_slip_speed", "the slip speed tested", "ATTENTION", true, NaN, NaN]);
const $c594 = $made(Rule, $c603, ["balance", "the energy balance", "FAULT OF THE PROGRAM", true, NaN, NaN]);
const $c595 = $made(Rule, $c603, ["sag", "the sag of the belt", "ATTENTION", false, NaN, NaN]);
const $c596 = $made(Rule, $c603, ["pulley_diameter", "the least pulley of the belt", "FAILS", false, NaN, NaN]);
const $c597 = $made(Rule, $c603, ["belt_thickness", "a trim without the thickness of the belt", "ATTENTION", true, NaN, NaN]);
const $c598 = $made(Rule, $c603, ["usual_sizes", "an unusual size", "ATTENTION", true, NaN, NaN]);
const $c599 = $made(Rule, $c603, ["motor_load", "the rating of a motor", "ATTENTION", true, 1.15, NaN]);
const $c600 = $made(Rule, $c603, ["momentary_load", "the torque that a motor bears in a start", "ATTENTION", true, NaN, NaN]);
const $c601 = $made(Rule, $c603, ["motor_heat", "the heat that a motor bears", "ATTENTION", true, NaN, NaN]);
const $c602 = $made(Rule, $c603, ["train_balance", "the balance of the train", "FAULT OF THE PROGRAM", true, NaN, NaN]);
const $c46 = new Map([["gross_slip", $c577], ["design_standard", $c578], ["creep", $c579], ["cover_creep", $c580], ["creep_interval", $c581], ["belt_tension", $c582], ["momentary_tension", $c583], ["belt_safety", $c584], ["face_pressure", $c585], ["bond_stress", $c586], ["fatigue_stress", $c587], ["tested_pressure_max", $c588], ["tested_pressure_min", $c589], ["condition", $c590], ["fit", $c591], ["tested_slip", $c592], ["tested_slip_speed", $c593], ["balance", $c594], ["sag", $c595], ["pulley_diameter", $c596], ["belt_thickness", $c597], ["usual_sizes", $c598], ["motor_load", $c599], ["momentary_load", $c600], ["motor_heat", $c601], ["train_balance", $c602]]);
const $c47 = new WeakMap();
const $c48 = new Map([[false, "Motor torque over rated torque, running"], [true, "Motor torque over rated torque, momentary"]]);
const $c604 = ["by creep", "The belt slides (creep of {slides})"];
const $c605 = ["by tested slip", "The slip reaches the end of the tests of lagging ⟦lagging⟧"];
const $c606 = ["by the largest friction", "The friction of the whole wrap is used up"];
const $c49 = new Map([[0, $c604], [1, $c605], [2, $c606]]);
const $c609 = [180.0, 1.2];
const $c610 = [200.0, 1.0];
const $c611 = [210.0, 1.0];
const $c612 = [220.0, 0.9];
const $c613 = [240.0, 0.8];
const $c607 = [$c609, $c610, $c611, $c612, $c613];
const $c614 = [180.0, 0.8];
const $c615 = [200.0, 0.7];
const $c616 = [210.0, 0.7];
const $c617 = [220.0, 0.6];
const $c618 = [240.0, 0.6];
const $c608 = [$c614, $c615, $c616, $c617, $c618];
const $c50 = new Map([["bare", $c607], ["lagged", $c608]]);
const $c640 = ["standard", "surface", "condition", "friction", "provenance"];
const $c641 = [0.25, 0.25];
const $c642 = $made(Provenance, $c530, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $c619 = $made(DesignFriction, $c640, ["CEMA", "bare", "", $c641, $c642]);
const $c643 = [0.35, 0.35];
const $c644 = $made(Provenance, $c530, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $c620 = $made(DesignFriction, $c640, ["CEMA", "rubber", "", $c643, $c644]);
const $c645 = [0.5, 0.5];
const $c646 = $made(Provenance, $c530, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", "dimpled ceramic"]);
const $c621 = $made(DesignFriction, $c640, ["CEMA", "ceramic", "", $c645, $c646]);
const $c647 = [0.35, 0.4];
const $c648 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c622 = $made(DesignFriction, $c640, ["DIN 22101", "bare", "dry", $c647, $c648]);
const $c649 = [0.1, 0.1];
const $c650 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c623 = $made(DesignFriction, $c640, ["DIN 22101", "bare", "wet", $c649, $c650]);
const $c651 = [0.05, 0.1];
const $c652 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c624 = $made(DesignFriction, $c640, ["DIN 22101", "bare", "wet and dirty", $c651, $c652]);
const $c653 = [0.4, 0.45];
const $c654 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c625 = $made(DesignFriction, $c640, ["DIN 22101", "rubber", "dry", $c653, $c654]);
const $c655 = [0.35, 0.35];
const $c656 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves; single value, partly from IS 11592 and REMA"]);
const $c626 = $made(DesignFriction, $c640, ["DIN 22101", "rubber", "wet", $c655, $c656]);
const $c657 = [0.25, 0.3];
const $c658 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c627 = $made(DesignFriction, $c640, ["DIN 22101", "rubber", "wet and dirty", $c657, $c658]);
const $c659 = [0.35, 0.4];
const $c660 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c628 = $made(DesignFriction, $c640, ["DIN 22101", "polyurethane", "dry", $c659, $c660]);
const $c661 = [0.35, 0.35];
const $c662 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c629 = $made(DesignFriction, $c640, ["DIN 22101", "polyurethane", "wet", $c661, $c662]);
const $c663 = [0.2, 0.2];
const $c664 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c630 = $made(DesignFriction, $c640, ["DIN 22101", "polyurethane", "wet and dirty", $c663, $c664]);
const $c665 = [0.4, 0.45];
const $c666 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c631 = $made(DesignFriction, $c640, ["DIN 22101", "ceramic", "dry", $c665, $c666]);
const $c667 = [0.35, 0.4];
const $c668 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c632 = $made(DesignFriction, $c640, ["DIN 22101", "ceramic", "wet", $c667, $c668]);
const $c669 = [0.35, 0.35];
const $c670 = $made(Provenance, $c530, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c633 = $made(DesignFriction, $c640, ["DIN 22101", "ceramic", "wet and dirty", $c669, $c670]);
const $c671 = [0.35, 0.35];
const $c672 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c634 = $made(DesignFriction, $c640, ["practice", "rubber", "dry", $c671, $c672]);
const $c673 = [0.35, 0.35];
const $c674 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c635 = $made(DesignFriction, $c640, ["practice", "rubber", "wet", $c673, $c674]);
const $c675 = [0.3, 0.3];
const $c676 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c636 = $made(DesignFriction, $c640, ["practice", "rubber", "wet and dirty", $c675, $c676]);
const $c677 = [0.8, 0.8];
const $c678 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c637 = $made(DesignFriction, $c640, ["practice", "ceramic", "dry", $c677, $c678]);
const $c679 = [0.45, 0.45];
const $c680 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c638 = $made(DesignFriction, $c640, ["practice", "ceramic", "wet", $c679, $c680]);
const $c681 = [0.35, 0.35];
const $c682 = $made(Provenance, $c530, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c639 = $made(DesignFriction, $c640, ["practice", "ceramic", "wet and dirty", $c681, $c682]);
const $c51 = [$c619, $c620, $c621, $c622, $c623, $c624, $c625, $c626, $c627, $c628, $c629, $c630, $c631, $c632, $c633, $c634, $c635, $c636, $c637, $c638, $c639];
const $c52 = new Map([["steel cord", 1600000.0], ["fabric", 140000.0]]);
const $c53 = new Map([["steel cord", 6.666666666666667], ["fabric", 8.0]]);
const $c54 = new Map([["illustrative", "on illustrative data"], ["untested", "on friction without tests"], ["estimated", "on estimated data"], ["calibrated", "on calibrated data"]]);
const $c55 = new WeakMap();
const $c56 = new Set(["cover_creep", "creep", "creep_interval", "design_standard", "gross_slip", "sag", "tested_pressure_min", "tested_slip", "uneven_creep"]);
const $c57 = new Set(["belt_safety", "belt_tension", "edge_tension", "face_pressure", "momentary_tension", "tested_pressure_max", "uneven_face_pressure", "uneven_pressure"]);
const $c58 = new Map([["uneven_creep", "creep"], ["uneven_pressure", "tested_pressure_max"], ["uneven_face_pressure", "face_pressure"], ["uneven_bond_stress", "bond_stress"], ["uneven_fatigue_stress", "fatigue_stress"], ["edge_tension", "belt_tension"]]);
const $c59 = new WeakMap();
const $c60 = $re("\\.?([A-Za-z_][A-Za-z0-9_]*)|\\[(\\d+)\\]", "");
const $c61 = ["format", "name", "title", "description", "surface", "thickness", "elastic_modulus", "shear_modulus", "compression_modulus", "block", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "slip_speed", "temperature", "condition_factor", "law", "provenance", "sources", "notes"];
const $c62 = ["name", "title", "description", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit"];
const $c64 = ["elastic_modulus", "shear_modulus", "compression_modulus", "block"];
const $c65 = ["thickness", "shear_modulus", "compression_modulus"];
const $c68 = new Map([["friction_coefficient", "friction"], ["slip_max", "tested_slip"], ["tested", "tested_pressure"], ["pieces.a", "A"], ["values", "rows"], ["peak_friction", "knots"], ["peak_slip", "knots"], ["post_peak_slope", "knots"], ["residual_friction", "knots"]]);
const $c69 = new Map([["integral-log", "knots"], ["table", "rows"]]);
const $c71 = $re("\\s*(?<sign>[+-])?\\s*(?<number>(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)?\\s*\\*?\\s*(?<factor>p(?:\\s*\\^\\s*(?:\\(\\s*(?<within>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\\s*\\)|(?<power>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)))?|ln\\(\\s*p\\s*\\)(?:\\s*\\^\\s*(?<log_power>[123]))?|exp\\((?<exponent>(?:[^()]|\\(\\s*p\\s*\\))*)\\))?\\s*", "");
const $c1360 = $made(Name, $c770, [60]);
const $c1351 = $made(Entry, $c759, ["name", $c1360, true, "", "name = \"my-lagging\"", "name", ""]);
const $c1361 = $made(Quantity, $c129, ["length", $c703]);
const $c1352 = $made(Entry, $c759, ["thickness", $c1361, false, "", "", "thickness", ""]);
const $c1362 = $made(Quantity, $c129, ["pressure", $c706]);
const $c1353 = $made(Entry, $c759, ["elastic_modulus", $c1362, false, "", "", "elastic_modulus", ""]);
const $c1364 = $made(Quantity, $c129, ["pressure", $c704]);
const $c1363 = $made(WordOr, $c796, ["rigid", $c1364, Infinity]);
const $c1354 = $made(Entry, $c759, ["shear_modulus", $c1363, false, "", "", "shear_modulus", ""]);
const $c1366 = $made(Quantity, $c129, ["pressure", $c705]);
const $c1365 = $made(WordOr, $c796, ["rigid", $c1366, Infinity]);
const $c1355 = $made(Entry, $c759, ["compression_modulus", $c1365, false, "", "", "compression_modulus", ""]);
const $c1367 = $made(Quantity, $c129, ["wear_coefficient", $c707]);
const $c1356 = $made(Entry, $c759, ["wear_coefficient", $c1367, false, "", "", "wear_coefficient", ""]);
const $c1368 = $made(Quantity, $c129, ["number", $c708]);
const $c1357 = $made(Entry, $c759, ["belt_energy_share", $c1368, false, "", "", "belt_energy_share", ""]);
const $c1369 = $made(Quantity, $c129, ["pressure", $c709]);
const $c1358 = $made(Entry, $c759, ["bond_strength", $c1369, false, "", "", "bond_strength", ""]);
const $c1370 = $made(Quantity, $c129, ["pressure", $c710]);
const $c1359 = $made(Entry, $c759, ["fatigue_limit", $c1370, false, "", "", "fatigue_limit", ""]);
const $c1349 = [$c747, $c1351, $c826, $c827, $c828, $c1352, $c1353, $c1354, $c1355, $c833, $c1356, $c1357, $c1358, $c1359, $c838, $c839, $c840, $c841, $c842, $c122, $c123, $c843];
const $c1350 = new Map([["format", $c747], ["name", $c1351], ["title", $c826], ["description", $c827], ["surface", $c828], ["thickness", $c1352], ["elastic_modulus", $c1353], ["shear_modulus", $c1354], ["compression_modulus", $c1355], ["block", $c833], ["wear_coefficient", $c1356], ["belt_energy_share", $c1357], ["bond_strength", $c1358], ["fatigue_limit", $c1359], ["cost", $c838], ["slip_speed", $c839], ["temperature", $c840], ["condition_factor", $c841], ["law", $c842], ["provenance", $c122], ["sources", $c123], ["notes", $c843]]);
const $c75 = $made(tables$Table, $c744, [Lagging, $c1349, $c1350]);
const $c683 = ["compression_modulus", "block"];
const $c76 = [$c683];
const $c77 = new Set(["belt_energy_share", "block", "bond_strength", "compression_modulus", "condition_factor", "cost", "elastic_modulus", "fatigue_limit", "law", "shear_modulus", "slip_speed", "temperature", "thickness", "wear_coefficient"]);
const $c78 = new RunsGain(0.0, 0.0);
const $c80 = ["effective_tension", "torque", "power"];
const $c81 = ["share", "speeds", "motor"];
const $c84 = ["data", "sense"];
const $c85 = new Map([["NOT CHECKED", 0], ["OK", 1], ["ATTENTION", 2], ["FAILS", 3], ["FAULT OF THE PROGRAM", 4]]);
const $c86 = $Decimal.of("0");
const $c87 = new Place("", "", "");
const $c88 = [""];
const $c688 = ["form", "coefficients", "sign"];
const $c689 = [0.0];
const $c89 = $made(Trend, $c688, ["polynomial", $c689, 1]);
const $c690 = [1000000000.0];
const $c90 = $made(Trend, $c688, ["polynomial", $c690, 1]);
const $c91 = new Map([["factor", $c691]]);
const $c92 = new Map([["x", $c692], ["y", $c692], ["diameter", $c693]]);
const $c694 = $made(Limit, $c765, ["force", 0.1, 1000000000.0, false, false]);
const $c93 = new Map([["entry", $c192], ["exit", $c694]]);
const $c94 = new Map([["creep_limit", $c695]]);
const $c696 = $made(Limit, $c765, ["length", 0.0, Infinity, true, false]);
const $c95 = new Map([["creep_limit", $c696]]);
const $c702 = $made(Limit, $c765, ["number", 1, 8, false, false]);
const $c96 = new Map([["rated_power", $c697], ["rated_speed", $c698], ["gear_ratio", $c699], ["gear_efficiency", $c700], ["motor_efficiency", $c701], ["count", $c702]]);
const $c97 = new Map([["thickness", $c703], ["shear_modulus", $c704], ["compression_modulus", $c705], ["elastic_modulus", $c706], ["wear_coefficient", $c707], ["belt_energy_share", $c708], ["bond_strength", $c709], ["fatigue_limit", $c710]]);
const $c98 = new Map([["ratio", $c711]]);
const $c99 = new Map([["entry_tension", $c192], ["exit_tension", $c694]]);
const $c100 = new Map([["sheave_ratio", $c712]]);
const $c101 = new Map([["friction", $c713], ["start_factor", $c714]]);
const $c102 = new Map([["running", $c714], ["starting", $c714], ["braking", $c714]]);
const $c103 = ["of"];
const $c124 = ["key", "kind", "example", "attribute"];
const $c131 = ["dimension"];
const $c133 = ["word", "kind"];
const $c164 = ["kind"];
const $c715 = ["balance", "train_balance", "across_balance"];
const $c716 = ["cover_creep", "creep_interval", "tested_slip_speed"];
const $c717 = ["gross_slip", "operating_point"];
const $c718 = ["on illustrative data", "on friction without tests", "on estimated data", "on calibrated data"];
const $c1371 = [false, false];
const $c1372 = [true, false];
const $c1373 = [true, true];
const $c1374 = [false, true];
const $c719 = new Map([["polynomial", $c1371], ["logarithmic", $c1372], ["power", $c1373], ["exponential", $c1374]]);
const $c724 = $made(_OfClass, [], []);
const $c725 = new Map([[10, null], [9, null]]);
const $c726 = $re("ST[ -]?(\\d{3,5})\\b", "");
const $c1375 = [80.0, 1.92];
const $c1376 = [90.0, 1.86];
const $c1377 = [100.0, 1.78];
const $c1378 = [120.0, 1.7];
const $c1379 = [140.0, 1.63];
const $c1380 = [160.0, 1.56];
const $c1381 = [180.0, 1.5];
const $c1382 = [200.0, 1.45];
const $c1383 = [250.0, 1.38];
const $c1384 = [300.0, 1.31];
const $c1385 = [350.0, 1.27];
const $c1386 = [400.0, 1.25];
const $c1387 = [450.0, 1.22];
const $c1388 = [500.0, 1.2];
const $c1389 = [550.0, 1.18];
const $c1390 = [600.0, 1.17];
const $c1391 = [700.0, 1.14];
const $c1392 = [800.0, 1.12];
const $c1393 = [900.0, 1.1];
const $c1394 = [1000.0, 1.09];
const $c1395 = [1500.0, 1.06];
const $c1396 = [2000.0, 1.05];
const $c729 = [$c1375, $c1376, $c1377, $c1378, $c1379, $c1380, $c1381, $c1382, $c1383, $c1384, $c1385, $c1386, $c1387, $c1388, $c1389, $c1390, $c1391, $c1392, $c1393, $c1394, $c1395, $c1396];
const $c1397 = $made(Limit, $c765, ["number", 0.0, Infinity, false, false]);
const $c1398 = $made(Limit, $c765, ["number", 1.0, Infinity, false, false]);
const $c731 = new Map([["residual_noise", $c1397], ["coverage_factor", $c1398]]);
const $c732 = $re("knots\\[([0-9]{1,4})\\]\\.(peak_slip|peak_friction)", "");
const $c733 = $Decimal.of("0");
const $c734 = new Map([["misalignment", $c1067], ["deflection", $c1069]]);
const $c735 = new Map([["diameter", $c185], ["wrap_angle", $c187], ["overrun", $c198], ["creep_limit", $c201], ["mass", $c204]]);
const $c736 = new Map([["spacing", $c1220], ["line_mass", $c1222], ["share", $c1224]]);
const $c1399 = $made(Limit, $c765, ["speed", 0.0, Infinity, true, false]);
const $c1400 = $made(Limit, $c765, ["number", 0.01, 100.0, false, false]);
const $c737 = new Map([["length", $c1151], ["lift", $c1153], ["belt_mass", $c1155], ["carry_idler_mass", $c1157], ["return_idler_mass", $c1159], ["material_mass", $c1155], ["capacity", $c1162], ["friction_factor", $c1164], ["length_coefficient", $c1166], ["secondary_resistance", $c1168], ["special_resistance", $c1168], ["return_share", $c1171], ["start_factor", $c1173], ["start_time", $c1175], ["stop_time", $c1175], ["take_up_tension", $c1178], ["counterweight", $c1180], ["take_up_distance", $c1182], ["speed", $c1399], ["sheave_ratio", $c1400]]);
const $c738 = new Map([["material", $c883], ["installation", $c885], ["area", $c888]]);
const $c739 = new Map([["width", $c864], ["height", $c866], ["stiffening", $c868], ["contact_fraction", $c870]]);
const $c1401 = $made(Limit, $c765, ["number", 0.0, 10.0, true, false]);
const $c740 = new Map([["factor", $c1401]]);
const $c741 = new Map([["rated_power", $c697], ["rated_speed", $c698], ["gear_ratio", $c699], ["gear_efficiency", $c700], ["motor_efficiency", $c701], ["count", $c702], ["setting", $c1285], ["droop", $c1287], ["torque_limit", $c1290]]);
const $c742 = new Map([["rated_power", $c697], ["rated_speed", $c698], ["gear_ratio", $c699], ["gear_efficiency", $c700], ["motor_efficiency", $c701], ["count", $c702], ["synchronous_speed", $c1311], ["breakdown_ratio", $c1313]]);
const $c743 = new Map([["length", $c1093], ["trough_angle", $c1095], ["centre_roll", $c1097]]);
const $c1402 = [0.016, 0.03];
const $c1403 = new Map([["distance", $c1082]]);
const $c1480 = $made(Limit, $c765, ["number", 0.0, 10.0, true, false]);
const $c1478 = $made(Quantity, $c129, ["number", $c1480]);
const $c1481 = $made(Limit, $c765, ["rotation_speed", 0.0, Infinity, true, false]);
const $c1479 = $made(Quantity, $c129, ["rotation_speed", $c1481]);
const $c1477 = $made(Either, $c1473, [$c1478, $c1479, "a trim like \"99.7 %\" or a drum speed like \"71.6 rpm\""]);
const $c1404 = $made(Rows, $c798, [$c1477, 1, 10]);
$sig(Problem, ["message", "remedy", "file", "key", "value", "line"]);
Problem.$compared = Problem.$names;
$sig(InputError, ["problems"], false);
$sig(Report, ["file"], false);
$sig(Report.prototype.add, ["place", "message", "remedy", "value"], false);
$sig(Record, ["values", "place", "raw", "faulty"], false);
$sig(Provenance, ["kind", "source", "date", "note"]);
Provenance.$compared = Provenance.$names;
$sig(Laggings, ["own", "folder", "allow_paths", "report"], false);
$sig(Condition, ["name", "factor", "factors", "standard", "source"]);
Condition.$compared = Condition.$names;
Condition.LIMITS = Condition.prototype.LIMITS = $c91;
$sig(Conditions, ["main", "cases"]);
Conditions.$compared = Conditions.$names;
$sig(Point, ["x", "y", "diameter", "turn"]);
Point.$compared = Point.$names;
Point.LIMITS = Point.prototype.LIMITS = $c92;
$sig(_UnitTextError, ["message", "remedy"], false);
$sig(Unit, ["factor", "powers", "zero"]);
Unit.$compared = Unit.$names;
$sig(UnitRow, ["unit", "factor", "larger"]);
UnitRow.$compared = UnitRow.$names;
$sig(WidthProfile, ["position", "value", "crown", "uncertainty"]);
WidthProfile.$compared = WidthProfile.$names;
$sig(Criteria, ["take_up", "standard", "safety", "sag"]);
Criteria.$compared = Criteria.$names;
$sig(Layers, ["pulley_cover", "carry_cover", "carcass"]);
Layers.$compared = Layers.$names;
$sig(Given, ["name", "place", "values", "raw", "diameter", "inherited"]);
Given.$compared = Given.$names;
$sig(Given.prototype.overridden, ["record", "fixed", "speed", "runs"], false);
$sig(NipTensions, ["entry", "exit"]);
NipTensions.$compared = NipTensions.$names;
$sig(Tensions, ["entry", "exit", "computed"]);
Tensions.$compared = ["entry", "exit"];
Tensions.LIMITS = Tensions.prototype.LIMITS = $c93;
$sig(LoadCase, ["name", "tensions", "kind", "condition"]);
LoadCase.$compared = LoadCase.$names;
$sig(Drive, ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description", "conveyor"]);
Drive.$compared = ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description"];
Drive.LIMITS = Drive.prototype.LIMITS = $c94;
$sig(Train, ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria"]);
Train.$compared = Train.$names;
Train.LIMITS = Train.prototype.LIMITS = $c95;
$sig(Reader, ["record", "belt", "pulleys", "report", "take_up"], false);
$sig(CatalogueBelt, ["name", "kind", "rating", "modulus", "least_pulley_diameter", "carcass", "carcass_mass", "cover_mass", "provenance", "carcass_source"]);
CatalogueBelt.$compared = CatalogueBelt.$names;
$sig(WrapArc, ["law", "entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "creep_limit", "belt_speed", "wear_coefficient", "pitch_offset", "cover_compliance", "cover_left_out", "side_of_belt", "belt_thickness", "centrifugal", "fit", "pulley", "load_case"]);
WrapArc.$compared = WrapArc.$names;
$sig(in_page$Given, ["entry_tension", "exit_tension", "effective_tension", "torque", "power", "diameter", "wrap_angle", "overrun", "recovery", "width", "modulus", "speed", "thickness", "shear_modulus", "compression_modulus", "wear_coefficient", "creep_limit", "steepest_fall", "pitch_offset", "cover_compliance", "mass", "slip_with_shear", "belt_speed"]);
in_page$Given.$compared = in_page$Given.$names;
$sig(Rise, ["tight", "slack"]);
Rise.$compared = Rise.$names;
$sig(in_page$Criteria, ["safety", "tight_rise", "slack_rise", "cover", "strength", "pulley_mass", "wet"]);
in_page$Criteria.$compared = in_page$Criteria.$names;
$sig(ArcResult, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy"]);
$sig(FoundArc, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy", "found"]);
$sig(DriveResult, ["drive", "arcs"]);
$sig(TrainResult, ["train", "cases"]);
$sig(CaseResult, ["case", "status", "reason", "members", "sensitivity", "belt_speed", "other_splits", "tension_error", "speed_error"]);
$sig(MemberResult, ["arc", "share", "speed_ratio", "contraction_term", "creep_term", "compression_term", "thickness_term", "drum_ratio", "surface_speed", "rotation_speed", "speed_trim", "drum_torque", "drum_power", "motor"]);
$sig(Place, ["pulley", "load_case", "event"]);
Place.$compared = Place.$names;
$sig(Sizes, ["width", "modulus", "speed", "diameter", "idle_wrap", "wrap_angle", "creep_limit", "overrun", "thickness", "shear_modulus", "compression_modulus", "rating", "strength", "bond_strength", "fatigue_limit", "face_pressure", "least_diameter", "sag", "entry", "leaving", "pull", "mass"]);
Sizes.$compared = Sizes.$names;
$sig(Check, ["name", "title", "level", "place", "value", "limit", "dimension", "at_most", "source", "short", "says", "remedy", "otherwise", "more", "binding", "miss"]);
Check.$compared = Check.$names;
$sig(Miss, ["level", "short", "says", "remedy", "fails_beyond", "because", "tolerates", "allows", "otherwise"]);
Miss.$compared = Miss.$names;
$sig(Motors, ["motors"]);
Motors.$compared = Motors.$names;
$sig(Motor, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes"]);
Motor.$compared = Motor.$names;
Motor.LIMITS = Motor.prototype.LIMITS = $c96;
$sig(Pulls, ["effective_tensions"]);
Pulls.$compared = Pulls.$names;
$sig(Speeds, ["rotation_speeds", "absolute"]);
Speeds.$compared = Speeds.$names;
$sig(Owner, ["of", "words", "place"]);
Owner.$compared = Owner.$names;
$sig(Sliding, ["place", "cause"]);
Sliding.$compared = Sliding.$names;
$sig(Asked, ["rule", "wrap_factor", "source", "why_not"]);
Asked.$compared = Asked.$names;
$sig(Figure, ["name", "title", "tension", "place", "binding", "at_least"]);
Figure.$compared = Figure.$names;
$sig(LeastTension, ["figures", "given", "counterweight"]);
LeastTension.$compared = LeastTension.$names;
$sig(Verdict, ["checks", "wet", "over_wet"]);
Verdict.$compared = Verdict.$names;
$sig(Row, ["title", "values", "symbol", "note", "name", "level"]);
Row.$compared = Row.$names;
$sig(Table, ["title", "rows", "heads", "note", "name", "short", "brief"]);
Table.$compared = Table.$names;
$sig(TestedRange, ["pressure_min", "pressure_max", "slip_max", "slip_speed"]);
TestedRange.$compared = TestedRange.$names;
$sig(FrictionLaw, ["slip_includes"]);
FrictionLaw.$compared = FrictionLaw.$names;
$sig(MeasuredTable, ["slip_includes", "slip", "pressure", "values"]);
MeasuredTable.$compared = MeasuredTable.$names;
MeasuredTable.title = MeasuredTable.prototype.title = "measured table";
$sig(_Term, ["coefficient", "function", "power", "exponent"]);
_Term.$compared = _Term.$names;
$sig(Trend, ["form", "coefficients", "sign"]);
Trend.$compared = Trend.$names;
$sig(Piece, ["a", "b", "post_peak_slope", "residual_friction"]);
Piece.$compared = Piece.$names;
$sig(CoefficientPieces, ["pressure", "pieces", "slip_unit", "continuity"]);
CoefficientPieces.$compared = CoefficientPieces.$names;
$sig(PressureKnots, ["pressure", "peak_friction", "peak_slip", "post_peak_slope", "residual_friction"]);
PressureKnots.$compared = PressureKnots.$names;
$sig(IntegralLog, ["slip_includes", "coefficients", "tested"]);
IntegralLog.$compared = IntegralLog.$names;
IntegralLog.title = IntegralLog.prototype.title = "integral-log law";
$sig(Factors, ["law", "by_slip_speed", "by_temperature", "slip_speed", "temperature"]);
Factors.$compared = Factors.$names;
$sig(Lagging, ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "block", "provenance", "sources", "notes", "description"]);
Lagging.$compared = ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "provenance", "sources", "notes", "description"];
Lagging.LIMITS = Lagging.prototype.LIMITS = $c97;
$sig(LoadGiven, ["entry_tension", "exit_tension", "effective_tension", "torque", "power"]);
LoadGiven.$compared = LoadGiven.$names;
$sig(DrumAt, ["diameter", "speed"]);
DrumAt.$compared = DrumAt.$names;
$sig(Shares, ["fractions"]);
Shares.$compared = Shares.$names;
$sig(Pair, ["entry", "exit"]);
Pair.$compared = Pair.$names;
$sig(TorqueFollower, ["master", "ratio"]);
TorqueFollower.$compared = TorqueFollower.$names;
TorqueFollower.LIMITS = TorqueFollower.prototype.LIMITS = $c98;
$sig(TrainCase, ["name", "entry_tension", "exit_tension", "division", "runs", "kind", "condition"]);
TrainCase.$compared = TrainCase.$names;
TrainCase.LIMITS = TrainCase.prototype.LIMITS = $c99;
$sig(RunsGain, ["base", "case"]);
RunsGain.$compared = RunsGain.$names;
$sig(BehindTakeUp, ["share", "behind", "runs"]);
BehindTakeUp.$compared = BehindTakeUp.$names;
$sig(Description, ["entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "belt_speed", "wear_coefficient", "shear_compliance", "pitch_offset", "centrifugal"]);
Description.$compared = Description.$names;
$sig(TakeUp, ["kind", "sheave_ratio", "after"]);
TakeUp.$compared = TakeUp.$names;
TakeUp.LIMITS = TakeUp.prototype.LIMITS = $c100;
$sig(DesignStandard, ["name", "condition", "friction", "start_factor", "binding"]);
DesignStandard.$compared = DesignStandard.$names;
DesignStandard.LIMITS = DesignStandard.prototype.LIMITS = $c101;
$sig(SafetyFactors, ["running", "starting", "braking", "source"]);
SafetyFactors.$compared = SafetyFactors.$names;
SafetyFactors.LIMITS = SafetyFactors.prototype.LIMITS = $c102;
$sig(Kind.prototype.built, ["value", "report"], true);
$sig(tables$Table, ["title", "of", "on_one_line"], false);
$sig(tables$Table.prototype.built, ["value", "report"], true);
$sig(Entry, ["key", "meaning", "kind", "title", "required", "alias", "example", "attribute", "unless", "stated"]);
$sig(Name, ["longest"]);
$sig(Text, ["longest", "lines"]);
$sig(Quantity, ["dimension", "limit"]);
$sig(Limit, ["dimension", "least", "most", "open", "rigid"]);
Limit.$compared = Limit.$names;
$sig(WordOr, ["word", "kind", "meaning"]);
$sig(ByName, ["kind", "most"]);
$sig(Belt, ["name", "width", "modulus", "rating", "strength", "speed", "kind", "momentary_factor", "least_pulley_diameter", "largest_wrap_pressure", "in_plane_shear_stiffness", "pulley_cover", "carry_cover", "carcass", "thickness", "cover_shear_modulus", "mass", "provenance", "sources"]);
Belt.$compared = Belt.$names;
Belt.LIMITS = Belt.prototype.LIMITS = $c4;
$sig(TextOr, ["text", "table"]);
$sig(Flag, []);
$sig(Choice, ["options"]);
$sig(Across, ["shell_profile", "worn_depth", "build_up", "misalignment", "deflection", "entry_profile", "before", "after", "strips"]);
Across.$compared = Across.$names;
Across.LIMITS = Across.prototype.LIMITS = $c734;
$sig(DimensionText, ["si_unit", "name", "example"]);
DimensionText.$compared = DimensionText.$names;
$sig(Definition, ["names", "factor", "unit", "zero"]);
Definition.$compared = Definition.$names;
$sig(Variant, ["tag", "meaning"], false);
$sig(Variant.prototype.built, ["value", "report"], true);
$sig(Pulley, ["name", "diameter", "wrap_angle", "lagging", "overrun", "recovery", "creep_limit", "side", "mass", "across", "sources", "conditions"]);
Pulley.$compared = Pulley.$names;
Pulley.LIMITS = Pulley.prototype.LIMITS = $c735;
$sig(Sag, ["spacing", "line_mass", "share"]);
Sag.$compared = Sag.$names;
Sag.SOURCE = Sag.prototype.SOURCE = "belt sag: T = m' g l/(8 h), a parabola; the rule of DIN 22101 and of CEMA, Belt Conveyors for Bulk Materials (6.25 S W for 2 %, 4.2 S W for 3 %)";
Sag.LIMITS = Sag.prototype.LIMITS = $c736;
$sig(Conveyor, ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio"]);
Conveyor.$compared = Conveyor.$names;
Conveyor.LIMITS = Conveyor.prototype.LIMITS = $c737;
$sig(Rule, ["name", "what", "missed", "at_most", "fails_beyond", "tolerates"]);
Rule.$compared = Rule.$names;
$sig(DesignFriction, ["standard", "surface", "condition", "friction", "provenance"]);
DesignFriction.$compared = DesignFriction.$names;
$sig(Cost, ["material", "installation", "currency", "area", "life_years"]);
Cost.$compared = Cost.$names;
Cost.LIMITS = Cost.prototype.LIMITS = $c738;
$sig(Block, ["shape", "width", "height", "stiffening", "contact_fraction"]);
Block.$compared = Block.$names;
Block.LIMITS = Block.prototype.LIMITS = $c739;
$sig(ConditionFactor, ["factor", "source"]);
ConditionFactor.$compared = ConditionFactor.$names;
ConditionFactor.LIMITS = ConditionFactor.prototype.LIMITS = $c740;
$sig(FrictionFactor, ["at", "factor", "source"]);
FrictionFactor.$compared = FrictionFactor.$names;
$sig(Fit, ["parameters", "values", "covariance", "residual_noise", "date", "method", "misfit", "misfit_accepted", "coverage_factor"]);
Fit.$compared = Fit.$names;
$sig(VariableSpeed, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "setting", "droop", "torque_limit"]);
VariableSpeed.$compared = VariableSpeed.$names;
VariableSpeed.LIMITS = VariableSpeed.prototype.LIMITS = $c741;
$sig(Induction, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio"]);
Induction.$compared = Induction.$names;
Induction.LIMITS = Induction.prototype.LIMITS = $c742;
$sig(FluidCoupling, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio", "coupling_load", "coupling_slip"]);
FluidCoupling.$compared = FluidCoupling.$names;
$sig(Load, ["entry_tension", "exit_tension", "creep_limit", "pressure_min", "pressure_max", "slip_max", "steepest_fall"]);
Load.$compared = Load.$names;
$sig(Transition, ["length", "trough_angle", "centre_roll", "depth"]);
Transition.$compared = Transition.$names;
Transition.LIMITS = Transition.prototype.LIMITS = $c743;
$sig(State, ["name", "kind", "resistances", "head", "tail", "entry", "exit"]);
State.$compared = State.$names;
$sig(Resistance, ["name", "carrying", "returning", "source"]);
Resistance.$compared = Resistance.$names;
$sig(OneOrMore, ["kind", "most"]);
$sig(Rows, ["kind", "least", "most"]);
$sig(Constant, ["slip_includes", "friction_coefficient", "tested"]);
Constant.$compared = Constant.$names;
Constant.title = Constant.prototype.title = "constant friction (Euler-Eytelwein)";
$sig(ElasticPlastic, ["slip_includes", "stiffness", "friction_coefficient", "tested"]);
ElasticPlastic.$compared = ElasticPlastic.$names;
ElasticPlastic.title = ElasticPlastic.prototype.title = "elastic-plastic";
$sig(PressurePower, ["slip_includes", "friction_coefficient", "reference_pressure", "exponent", "tested"]);
PressurePower.$compared = PressurePower.$names;
PressurePower.title = PressurePower.prototype.title = "power of pressure";
$sig(Profile, ["dimension", "diameters"], false);
Profile.words = Profile.prototype.words = "rows, or a table";
$sig(GrippingPulley, ["distance"]);
GrippingPulley.$compared = GrippingPulley.$names;
GrippingPulley.LIMITS = GrippingPulley.prototype.LIMITS = $c1403;
$sig(Count, ["least", "most"]);
$sig(Elsewhere, []);
$sig(Either, ["first", "second", "words"]);
Either.$compared = Either.$names;
$sig(SpeedList, []);
SpeedList.$compared = SpeedList.$names;
SpeedList.rows = SpeedList.prototype.rows = $c1404;
$sig(CompactLaw, ["kind", "edges", "coefficients", "slips", "onset_compliance"]);
CompactLaw.$compared = CompactLaw.$names;
$sig(_Pair, ["dimension"], false);
export { drive_file__drive_from_document as readDrive };
export { file__train_from_document as readTrain };
export { InputError as InputError };
export { CatalogueBelt as CatalogueBelt };
export { Provenance as Provenance };
export { source__syntax_problem as syntaxProblem };
export { in_page_checks__arcs_of as arcsOf };
export { in_page_checks__given_of as givenOf };
export { in_page_checks__criteria_of as criteriaOf };
export { in_page_checks__results_of as resultsOf };
export { in_page_checks__result_of as resultOf };
export { in_page_checks__train_drive as trainDrive };
export { in_page_checks__running_at as runningAt };
export { TrainResult as TrainResult };
export { CaseResult as CaseResult };
export { MemberResult as MemberResult };
export { in_page_checks__alone as alone };
export { in_page_checks__remarks_of as remarksOf };
export { in_page_checks__weak_kinds as weakKinds };
export { in_page_checks__unjudged as unjudged };
export { judge__judge as judge };
export { least_tension__least_tension as leastTension };
export { least_tension__least_sentence as leastSentence };
export { least_tension__least_table as leastTable };
export { least_tension__shown_least as shownLeast };
export { checks_table__check_table as checkTable };
export { words__short as short };
export { words__alone_of as aloneOf };
