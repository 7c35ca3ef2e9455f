// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import { answer__operating_point, compression__block_modulus, compression__shape_factor, load_case__exit_behind, load_case__resultant, numbers__idles, pitch__centrifugal_force, summary__available, summary__geometry_of, summary__held_creep, summary__overrun_loosens, summary__recovery_compliance, summary__spring_rate, summary__too_steep, tension_rules__behind_take_up, tension_rules__effective_keys, tension_rules__ends_of, tension_rules__families, tension_rules__fault_of, tension_rules__filled, tension_rules__less_runs, tension_rules__overridden, tension_rules__pull_given, tension_rules__speed_missing, tension_rules__too_few } from "./kernel.js";
import { cell__percent, cell__quantity } from "./cells.js";
import { cellOf } from "./base/digits.js";
import { belts, isNumber, laggingNames, laggingText, overridden, parsed, readText, term } from "./documents.js";
import { $Decimal, $Dict, $Error, $KeyError, $Object, $OverflowError, $StopIteration, $Tuple, $TypeError, $ValueError, $add, $and, $at, $b, $bound, $call, $common, $eq, $fields, $format, $in, $iter, $k, $kept, $m, $made, $map, $math, $merged, $method, $mul, $named, $neg, $once, $or, $pow, $put, $re, $replaced, $repr, $shown, $sig, $slice, $str, $sub, $told, $truth } from "./python.js";
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
throw errors__input_error(message, remedy, file, "format", $shown(given));
}
function errors__input_error(message, remedy = "", file = "", key = "", value = "", line = null) {

return new InputError(new Problem(message, remedy, file, key, value, line));
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
return errors__input_error(("" + "the catalogue has no " + $str(what) + " of this name"), $m.strip(("" + $str(remedy) + " The command `" + $str(command) + "` lists them.")), undefined, undefined, $shown(name));
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
return errors__input_error(message, remedy, undefined, undefined, $shown(given));
}
function parse___no_unit(value, dimension) {
let kind, message;
(kind = $at($c12, dimension));
(message = ("" + "no unit, where " + $str(kind.name) + " is needed"));
return parse___refused(value, message, ("" + "Write the unit too, for example " + $str($shown($bound(kind, "example"))) + "."));
}
function parse___refused(given, message, remedy) {
return errors__input_error(message, remedy, undefined, undefined, $shown(given));
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
return numbers___refused(text, "digits other than 0-9", "Type digits and a decimal point, such as 1234.5.");
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
return numbers___refused(text, "a fraction, where a decimal number is needed", "Type digits and a decimal point, such as 1234.5.");
}
if (($in("−", digits))) {
return numbers___refused(text, "a typographic minus sign", "Use the plain hyphen-minus '-'.");
}
return numbers___refused(text, "not a plain number", "Type digits and a decimal point, such as 1234.5.");
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
return "Type digits and a decimal point, such as 1234.5.";
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
$method(report, "add", [$bound(item, "place"), $bound(fault, "message"), $bound(fault, "remedy")], [["code", "few_tensions"]]);
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
$m.append(problems, new Problem("missing", remedy, undefined, first, undefined, undefined, "missing"));
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
return $replaced(drive, new Map([["load_cases", $b.tuple($slice([...$iter(cases), ...$iter(drive.load_cases)], null, 1))]]));
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
function in_page_checks__idle_in(drive) {

return $b.any((function* () { for (const arc of $iter(in_page_checks__arcs_of(drive))) { yield rule__idle(arc); } })());
}
function rule__idle(arc) {

return numbers__idles($bound(arc, "entry_tension"), $bound(arc, "exit_tension"));
}
function judge__judge(result) {
let most, one, over, verdict;

if ((!$in(result, $c43))) {
(verdict = new Verdict(judge__sound(judge__every_check(result), least_tension__least_tension(result))));
if ((verdict.level === "OK")) {
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
([most, over] = judge___wet(one));
(verdict = $replaced(verdict, new Map([["wet", most], ["over_wet", over]])));
}
$put($c43, result, verdict);
}
return $at($c43, result);
}
function judge__every_check(result) {

return $b.tuple(($truth($b.isinstance(result, TrainResult)) ? judge___train(result) : judge___drive(result)));
}
function* judge___train(result) {
let case_, check, checks, failing;
(checks = [...$iter(judge___of_members(result))]);
(failing = new Set((function* () { for (const check of $iter(checks)) { if (!((check.level === "FAILS"))) continue; yield check.place.load_case; } })()));
for (check of $iter(checks)) {
if ((($eq(check.name, "fight")) && $truth(check.missed) && ($in(check.place.load_case, failing)))) {
(case_ = result.train.case($bound(check.place, "load_case")));
if (($at($at(check.more, "lost"), 0) > $mul(0.1, $b.abs($bound(case_, "effective_tension"))))) {
yield $replaced(check, new Map([["level", "FAILS"]]));
continue;
}
}
yield check;
}
}
function* judge___of_members(result) {
let adrift, case_, check, title;
for (case_ of $iter(result)) {
yield* $iter(of_train__of_case($bound(result, "train"), case_));
if ($truth($b.isinstance(case_.case.division, Pulls))) {
yield* $iter(of_train__meetings(case_));
}
}
(adrift = new Set((function* () { for (const case_ of $iter(result)) { if (!($truth(case_.adrift))) continue; yield case_.case.name; } })()));
for (check of $iter(judge___drive(result.drive_result(), ...$iter(usual__owners_of($bound(result, "train")))))) {
if ((($eq(check.name, "gross_slip")) && ($in(check.place.load_case, adrift)))) {
(title = $m.format("Safety against gross slip, {}", [$bound(result.train.case($bound(check.place, "load_case")), "kind")], $map([])));
yield rule__not_checked($bound(check, "name"), title, "no division of the load is found", $bound(check, "place"));
} else {
yield check;
}
}
}
function* of_train__of_case(train, case_) {
let driven, driven_by, helps, lost, motors, overrun, place, several;

(place = new Place("", $bound(case_.case, "name")));
if (($truth(case_.adrift) || ($in(case_.status, ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."])))) {
(overrun = $b.any((function* () { for (const [m, motor] of $iter($b.zip($bound(case_, "members"), of_train___motors($bound(case_, "case")), $k({strict: false})))) { if (!($truth($b.isinstance(motor, Motor)))) continue; yield $and((m.motor != null), () => $and((m.motor.motor_load < 0.0), () => !$truth(motor.brakes))); } })()));
yield of_train__operating_point($bound(case_, "status"), $bound(case_, "reason"), place, overrun);
}
(several = ($b.len($bound(case_, "members")) > 1));
if (!$truth($told($c40, case_.status, "solved"))) {
yield* $iter(($truth(several) ? of_train__not_working(place) : []));
return null;
}
if ($truth(several)) {
(lost = numbers__pull_against([...(function* () { for (const m of $iter(case_.members)) { yield m.arc.effective_tension; } })()]));
yield of_train__fight(lost, place, $bound(case_.case, "division"));
(driven = [...(function* () { for (const [p, m] of $iter($b.zip($bound(train, "pulleys"), $bound(case_, "members"), $k({strict: true})))) { if (!(!$truth(rule__idle($bound(m.arc, "arc"))))) continue; yield p; } })()]);
yield* $iter(of_drive__unknown_trims($bound(train, "belt"), driven, place));
}
yield of_train__train_balance($b.max($bound(case_, "tension_error"), $bound(case_, "speed_error")), place);
(motors = of_train___motors($bound(case_, "case")));
(driven_by = [...$iter($b.zip($bound(case_, "members"), motors, $k({strict: false})))]);
(helps = !$truth($b.all((function* () { for (const [m, motor] of $iter(driven_by)) { yield of_train___motor(m, motor, $bound(case_, "case"), true).missed; } })())));
yield* $iter((function* () { for (const [m, motor] of $iter(driven_by)) { yield of_train___motor(m, motor, $bound(case_, "case"), helps); } })());
}
function of_train___motors(case_) {
return ($truth($b.isinstance(case_.division, Motors)) ? case_.division.motors : []);
}
function of_train__operating_point(status, reason, place, overrun = false) {
let _, fault, remedy, says, shorts;

([says, _, remedy] = $m.partition($b.str(status), ". "));
if ($truth(overrun)) {
(remedy = ("" + "Set brakes = true for its motor if its drive can hold back. " + $str(remedy)));
}
(fault = (status === "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."));
(shorts = $map([["Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", "gross slip"], ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", "beyond a motor"]]));
return new Check("operating_point", "Operating point of the drives", ($truth(fault) ? "FAULT OF THE PROGRAM" : "FAILS"), place, undefined, undefined, undefined, undefined, undefined, $m.get(shorts, status, "not solved"), check__escaped($m.strip(("" + $str(reason) + " " + $str(says) + "."))), check__escaped(remedy));
}
function check__escaped(text) {

return $m.replace($m.replace(text, "{", "{{"), "}", "}}");
}
function* of_train__not_working(place) {
let name, title;

for ([name, title] of $iter([["fight", "Drives work together"], ["train_balance", "Tensions, speeds and torques of the train agree"]])) {
yield rule__not_checked(name, title, "the drives do not carry the load", place);
}
}
function rule__not_checked(name, title, why, place) {

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
function of_train__fight(lost, place, division) {
let fights, remedy;

(fights = (lost > 0.0));
(remedy = "Bring their speeds closer together, or divide the load by torque.");
if ($truth($b.isinstance(division, Shares))) {
(remedy = "Correct the shares: one below 0 % brakes against the others.");
} else {
if ($truth($b.isinstance(division, Pulls))) {
(remedy = "Correct the tensions: one of the pulleys is given as braking.");
}
}
return new Check("fight", "Drives work together", ($truth(fights) ? "ATTENTION" : "OK"), place, undefined, undefined, undefined, undefined, undefined, ($truth(fights) ? "drives fight" : ""), ($truth(fights) ? "The drives work against each other with {lost} of pull." : ""), ($truth(fights) ? remedy : ""), undefined, $map([["lost", [lost, "force"]]]));
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

(why = ("" + "{layer} of belt on drums of two diameters shifts it by {shift} % against " + $str(first) + "."));
if ($truth(opposite)) {
(why = ("" + "it meets the other side of the belt than " + $str(first) + ", and covers that differ by {apart} shift it by {shift} %."));
}
return new Check("belt_thickness", "Trim by the thickness of the belt", "ATTENTION", place, undefined, undefined, undefined, undefined, undefined, "trim without belt thickness", ("" + "The trim of " + $str(check__escaped($bound(place, "pulley"))) + " is that of a belt without thickness: " + $str(why)), "Give the pulley cover, carry cover and carcass of the belt.", undefined, $map([["shift", [$mul(100.0, shift), "number"]], [($truth(opposite) ? "apart" : "layer"), [($truth(opposite) ? 0.004 : 0.01), "length"]]]), false);
}
function of_train__train_balance(error, place) {
let words;

(words = new Words("Tensions, speeds and torques of the train agree", "tolerance of the program", "out of balance", "Tensions, speeds and torques of the train miss each other by {value}.", undefined, undefined, "Please report the drive file; until then change a value slightly."));
return $c44.judged(error, 1e-05, place, words);
}
function of_train___motor(member, motor, case_, helps) {
let at, momentary;

([at, momentary] = [new Place($bound(member, "name"), $bound(case_, "name")), (!$eq(case_.kind, "running"))]);
if (((member.motor == null) || !$truth($b.isinstance(motor, Motor)))) {
return of_train__unrated(momentary, at);
}
return of_train__motor_load($bound(member.motor, "motor_load"), motor.bears(momentary), momentary, at, helps);
}
function of_train__unrated(momentary, place) {
let name, why;

(name = ($truth(momentary) ? "momentary_load" : "motor_load"));
(why = "a drive that follows another gives no rating of its motors");
return rule__not_checked(name, $at($c45, momentary), why, place);
}
function of_train__motor_load(load, most, momentary, place, helps) {
let other, remedy, title, words;

(title = $at($c45, momentary));
(remedy = "Divide the load otherwise (diameters, speeds, torque sharing), or take larger motors.");
if (!$truth(helps)) {
(remedy = "Take larger motors: no other division of the load helps.");
}
if ($truth(momentary)) {
(other = ($truth(helps) ? "divide the load otherwise, " : ""));
(remedy = ("" + "Start and stop more slowly, " + $str(other) + "or take larger motors."));
}
(words = new Words(title, ($truth(momentary) ? "IEC 60034-1: 1.6 times the rated torque for 15 s; no stall at 90 % of the voltage (NEMA MG 1-12.44, condensed edition of 2011: torque falls with its square)" : "rating of the motor, continuous duty"), "motor overloaded", "The motors work at {percent} % of their rated torque, and may at {most} %.", "The usual service factor, 1.15, does not cover that (NEMA MG 1-14.37: up to that of the nameplate).", undefined, remedy, undefined, $map([["percent", [$mul(100.0, $b.abs(load)), "number"]], ["most", [$mul(100.0, most), "number"]]])));
return ($truth(momentary) ? $c46 : $c47).judged($b.abs(load), most, place, words);
}
function* of_train__meetings(case_) {
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
yield new Check("meeting", "Tensions of neighbouring pulleys meet", "ATTENTION", place, undefined, undefined, undefined, undefined, undefined, "tensions do not meet", ("" + "The belt leaves pulley " + $str(check__escaped(before)) + " with {leaves} and enters pulley " + $str(check__escaped(after)) + " with {enters}: taken as what the run between them adds."), ("" + "If none does, correct the tensions or the order of the pulleys; if one does, give what the run before pulley " + $str(check__escaped(after)) + " adds."), undefined, $map([["leaves", [leaves, "force"]], ["enters", [enters, "force"]]]), false);
}
function* usual__owners_of(train) {
let division, kinds, motor, pulley, turns;

(division = $at(train.cases, 0).division);
if (($truth($b.isinstance(division, Speeds)) && $truth(division.absolute))) {
for ([pulley, turns] of $iter($b.zip($bound(train, "pulleys"), $bound(division, "rotation_speeds"), $k({strict: true})))) {
yield new Owner(turns, $c48, "", new Place($bound(pulley, "name")));
}
}
for ([pulley, motor] of $iter($b.zip($bound(train, "pulleys"), ($truth($b.isinstance(division, Motors)) ? division.motors : []), $k({strict: false})))) {
(kinds = ($truth($b.isinstance(motor, Motor)) ? $c49 : ["TorqueFollower"]));
yield new Owner(motor, kinds, ("" + "of the motor of pulley " + $str(pulley.name)), new Place($bound(pulley, "name")));
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
yield* $iter(judge__diameters(drive));
yield* $iter(usual__usual_sizes(drive, ...$iter(others)));
for (pulley of $iter(drive.pulleys)) {
yield of_data__data(drive, pulley);
}
}
function* judge___case(drive, case_, arcs) {
let index, pulley, result, rule, spot;
for ([index, result] of $iter($b.enumerate(arcs))) {
(pulley = drive.pulley($bound(result.arc, "pulley")));
yield of_arc__grip(drive, case_, arcs, index);
(spot = rules__spot_of(drive, case_, pulley, result));
for (rule of $iter($c53)) {
yield* $iter(rule.checks(spot));
}
if (($truth($b.all((function* () { for (const arc of $iter(arcs)) { yield rule__idle($bound(arc, "arc")); } })())) || ((result.arc.side < 0.0) && !$truth(rule__idle($bound(result, "arc")))))) {
yield of_drive__sense(case_, pulley);
}
}
}
function of_arc__grip(drive, case_, arcs, index) {
let name, place, result, rise, take_up, title;

(result = $at(arcs, index));
([take_up, name] = [drive.criteria.take_up, "gross_slip"]);
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
(title = $m.format("Safety against gross slip, {}", [$bound(case_, "kind")], $map([])));
if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return new Check(name, title, "FAULT OF THE PROGRAM", place, undefined, undefined, undefined, undefined, undefined, "not solved", check__escaped($b.str($bound(result, "status"))));
}
if ($truth(rule__idle($bound(result, "arc")))) {
return new Check(name, "No pull to carry", "OK", place, undefined, undefined, undefined, undefined, undefined, "not driven");
}
(rise = gross_slip__rises([...(function* () { for (const r of $iter(arcs)) { yield r.arc; } })()], index, take_up));
return of_arc__of_sliding(drive, case_, result, in_page_checks__sliding(result, rise));
}
function in_page_checks__sliding(result, _rise) {

return new Sliding($bound(result.found, "place"), $bound(result.found, "cause"));
}
function of_arc__of_sliding(drive, case_, result, found) {
let by, check, factor, first, gone, lagging, place, rule, safety, says, take_up, title, value, words;

([safety, take_up, lagging] = [drive.criteria.safety, drive.criteria.take_up, result.arc.pulley]);
([rule, factor, gone] = [$c50, safety.of($bound(case_, "kind")), !$truth($told($c40, result.status, "solved"))]);
([by, first] = $at($c51, found.cause));
(title = ("" + $str($m.format("Safety against gross slip, {}", [$bound(case_, "kind")], $map([]))) + ", " + $str(by)));
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
if (($truth($math.isnan($bound(found, "place"))) && !$truth(gone))) {
return rule__not_checked($bound(rule, "name"), title, "where the belt slides was not found", place);
}
if (($eq(found.cause, 1))) {
(rule = $replaced(rule, new Map([["fails_beyond", NaN]])));
}
(first = $m.replace(first, "⟦lagging⟧", check__escaped($bound(drive.pulley(lagging).lagging, "name"))));
(says = ("" + $str(first) + " at {value} times the pull, below {limit}; safety factor " + $str(case_.kind) + ", "));
(says = $add(says, ("" + $str(of_arc__held_words(take_up)) + ".")));
(words = new Words(title, ("" + "safety factor " + $str(case_.kind) + ": " + $str($or(safety.source, () => "taken where the drive file says nothing"))), (($eq(found.cause, 1)) ? "pull beyond tests" : "near gross slip"), says, "So it slides.", undefined, "Raise the slack-side tension, enlarge the wrap angle, or choose a lagging with more friction.", "No slack-side tension is enough: enlarge the wrap angle, or choose a lagging with more friction.", $map([["slides", [0.0635, "length"]]])));
(value = ($truth(gone) ? $b.min($bound(found, "place"), 0.999) : found.place));
(check = rule.judged(value, factor, place, words));
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
function rules__spot_of(drive, case_, pulley, result = null) {
let belt, driving, first, known, last, slack, tensions;

([tensions, belt] = [$at(case_.tensions, pulley.name), drive.belt]);
(known = $and((result != null), () => $told($c40, result.status, "solved")));
([first, last] = [$at(drive.pulleys, 0), $at(drive.pulleys, $neg(1))]);
(driving = ($at(case_.tensions, first.name).entry >= $at(case_.tensions, last.name).exit));
(slack = ($truth(driving) ? last : first));
return new Spot(drive, case_, pulley, new Place($bound(pulley, "name"), $bound(case_, "name")), new State($b.max($bound(tensions, "entry"), $bound(tensions, "exit")), $b.min($bound(tensions, "entry"), $bound(tensions, "exit")), (($eq(pulley.name, slack.name)) ? drive.slack_end(case_) : NaN), belt.width, pulley.diameter, ((belt.breaking_strength == null) ? NaN : belt.breaking_strength), pitch__centrifugal_of(belt), drive.creep_limit_of(pulley), NaN, (((result != null) && $truth(known)) ? rules___found(result) : $map([]))), result, (((result == null) || $truth(known)) ? "" : of_arc__no_state(result)));
}
function rules___found(result) {
let course;

(course = $map([["largest_slip", in_page_checks__largest_slip], ["slip_speed", in_page_checks__slip_speed]]));
return $map([...(function* () { for (const name of $iter($c52)) { yield [name, (($in(name, course)) ? $at(course, name)(result) : $b.abs($b.getattr(result, name)))]; } })()]);
}
function in_page_checks__largest_slip(result) {

return result.found.largest_slip;
}
function in_page_checks__slip_speed(result) {

return result.found.slip_speed;
}
function of_arc__no_state(result) {

if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return "the arc was not solved";
}
return "in gross slip the belt has no state at rest";
}
function of_drive__sense(case_, pulley) {
let none, tensions, told;

(tensions = $at(case_.tensions, pulley.name));
(none = numbers__idles($bound(tensions, "entry"), $bound(tensions, "exit")));
(told = ($truth(none) ? "pulls nothing (T1 = T2)" : "brakes (T1 < T2)"));
return new Check("sense", ("" + "Pulley " + $str(pulley.name) + " " + $str(told)), "OK", new Place($bound(pulley, "name"), $bound(case_, "name")), undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
function* in_page_checks__across(_result) {

yield* $iter([]);
}
function* of_drive__take_up(drive) {
let case_, first, fixed, held, high, kind, last, low, ordered, other, place, what, where;

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
(place = check__escaped($m.removeprefix(drive.take_up_place, "at the take-up ")));
(what = ($truth(place) ? ("" + "the tension " + $str(place)) : "the slack-side tension"));
(what = ($truth(fixed) ? "the sum of both tensions" : what));
(other = (($truth(fixed) || $truth(drive.criteria.take_up.after)) ? "" : of_drive___steady(drive)));
(where = ($truth(other) ? ("" + ", or say that it stands after pulley " + $str(other)) : ""));
yield new Check("take_up", "Tensions that the take-up holds", "ATTENTION", undefined, undefined, undefined, undefined, undefined, ("" + "take-up " + $str(kind) + ", as given"), "contradicts take-up", ("" + "A " + $str(kind) + " take-up holds " + $str(what) + " at one value: it is {least} in load case " + $str(check__escaped(low)) + " and {most} in load case " + $str(check__escaped(high)) + "."), ("" + "Correct the tensions, or the kind of the take-up" + $str(check__escaped(where)) + "."), undefined, $map([["least", [$at(held, low), "force"]], ["most", [$at(held, high), "force"]]]), false);
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
function of_drive___steady(drive) {
let behind, pulley;

for (pulley of $iter(drive.pulleys)) {
(behind = [...(function* () { for (const case_ of $iter(drive.load_cases)) { yield $at(case_.tensions, pulley.name).exit; } })()]);
if ($truth(numbers__held_alike($b.min(behind), $b.max(behind)))) {
return pulley.name;
}
}
return "";
}
function* judge__diameters(drive) {
let pulley, spot;

for (pulley of $iter(drive.pulleys)) {
(spot = rules__spot_of(drive, $at(drive.load_cases, 0), pulley));
yield* $iter($c54.checks($replaced(spot, new Map([["place", new Place($bound(pulley, "name"))]]))));
}
}
function* usual__usual_sizes(drive, ...others) {
let odd, parts, title;

(parts = [...$iter(usual___others(drive, others))]);
(odd = $map([...(function* () { for (const check of $iter([...$iter(usual__unusual_sizes(drive, $b.bool(parts))), ...$iter(parts)])) { yield [check.said, check]; } })()]));
yield* $iter($m.values(odd));
if (!$truth(odd)) {
(title = "What is given is of usual size");
yield new Check("usual_sizes", title, "OK", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
}
function* usual___others(drive, others) {
let ends, fabric, lagging, owner, place, pulley, rating, solid, stiff, width;
for (owner of $iter([...$iter(usual___owners(drive)), ...$iter(others)])) {
yield* $iter(usual___of_owner(owner));
if (($in(owner.kinds, [$c49, $c48]))) {
yield* $iter(usual___turning(drive, owner));
}
}
yield* $iter(usual___motor_sizes(drive, [...(function* () { for (const o of $iter(others)) { if (!(($eq(o.kinds, $c49)))) continue; yield o.of; } })()]));
if ((drive.conveyor != null)) {
yield* $iter(usual___conveyor_sizes($bound(drive, "conveyor"), $bound(drive.belt, "width")));
}
(width = drive.belt.width);
for (pulley of $iter(drive.pulleys)) {
if ((pulley.mass != null)) {
(solid = $mul($mul($mul($mul(7850.0, 0.25), 3.141592653589793), $pow(pulley.diameter, 2)), width));
(ends = [$mul(0.02, solid), $mul(1.5, solid)]);
if (!$truth(numbers__usual($bound(pulley, "mass"), ...$iter(ends)))) {
(place = new Place($bound(pulley, "name")));
yield usual__unusual(("" + "mass of pulley " + $str(pulley.name)), "mass", place, $bound(pulley, "mass"), ends);
}
}
}
([rating, stiff] = [drive.belt.rating, drive.belt.modulus]);
(fabric = $and(($eq(drive.belt.kind, "fabric")), () => $and(rating, () => numbers__usual(rating, ...$iter($at($c65, 11))))));
if (($truth(fabric) && $truth(rating) && !$truth(numbers__usual((stiff / rating), 0.0, 250.0)))) {
yield usual__unusual("modulus over the rating of the belt", "number", $c58, (stiff / rating), [15.0, 250.0]);
}
for (lagging of $iter(drive.laggings)) {
yield* $iter(usual___law_sizes(lagging));
}
}
function* usual___owners(drive) {
let criteria, factor, lagging, name, of, place, pulley;

(criteria = drive.criteria);
yield new Owner($bound(drive, "belt"), ["Belt"], "of the belt");
yield new Owner($bound(criteria, "take_up"), ["TakeUp"], "of the take-up");
yield new Owner($bound(criteria, "standard"), ["DesignStandard"], "of the design standard");
yield new Owner($bound(criteria, "safety"), ["SafetyFactors"], "safety factor");
yield new Owner($bound(criteria, "sag"), ["Sag"], "for the sag of the belt");
yield new Owner($bound(drive, "conveyor"), ["Conveyor"], "of the conveyor");
for (lagging of $iter(drive.laggings)) {
(of = ("" + "of lagging " + $str(lagging.name)));
yield new Owner(lagging, ["Lagging"], of);
yield new Owner($bound(lagging, "block"), ["Block"], ("" + "of the blocks " + $str(of)));
yield new Owner($bound(lagging, "cost"), ["Cost"], ("" + "that the cost " + $str(of) + " is for"));
for ([name, factor] of $iter($m.items(lagging.condition_factors))) {
yield new Owner(factor, ["ConditionFactor"], ("" + "on the friction " + $str(of) + ", " + $str(name)));
}
}
for (pulley of $iter(drive.pulleys)) {
([place, of] = [new Place($bound(pulley, "name")), ("" + "of pulley " + $str(pulley.name))]);
if ((pulley.across != null)) {
yield new Owner($bound(pulley, "across"), ["Across"], of, place);
yield new Owner($bound(pulley.across, "before"), $c55, ("" + "before pulley " + $str(pulley.name)), place);
yield new Owner($bound(pulley.across, "after"), $c55, ("" + "behind pulley " + $str(pulley.name)), place);
}
}
}
function* usual___of_owner(owner) {
let check, ends, happening, heights, key, limit, limits, most, name, of, profile, tables, value;

([of, limits] = [owner.of, $or($b.getattr($bound(owner, "of"), "LIMITS", null), () => $map([]))]);
(tables = [...$iter(owner.more), ...$iter((function* () { for (const kind of $iter(owner.kinds)) { yield $m.get($c56, kind, $map([])); } })())]);
for ([key, limit] of $iter($m.items(limits))) {
([ends, value] = [$b.next((function* () { for (const t of $iter(tables)) { if (!(($in(key, t)))) continue; yield $at(t, key); } })(), null), $b.getattr(of, key)]);
if (($truth(ends) && $truth(value) && !$truth(numbers__usual(value, ...$iter(ends))))) {
(name = $m.rstrip(("" + $str($m.replace(key, "_", " ")) + " " + $str(owner.words))));
yield usual__unusual(name, $bound(limit, "dimension"), $bound(owner, "place"), value, ends);
}
}
for (happening of $iter($or($b.getattr(of, "happenings", null), () => []))) {
if ((happening.at >= of.duration)) {
(name = ("" + "begin (at) of what happens " + $str(owner.words)));
(check = usual__unusual(name, "time", $c58, $bound(happening, "at"), [0.0, of.duration]));
yield $replaced(check, new Map([["remedy", "Nothing happens then: give an earlier time."]]));
}
}
if (($in("Across", owner.kinds))) {
for ([key, most] of $iter($m.items($c59))) {
(profile = $b.getattr(of, key));
(heights = ((profile == null) ? [] : [profile.largest, $neg($b.min([...$iter(profile.value), 0.0]))]));
if (($b.max(heights, $k({default: 0.0})) > most)) {
(name = $m.rstrip(("" + $str($m.replace(key, "_", " ")) + " " + $str(owner.words))));
yield usual__unusual(name, "length", $bound(owner, "place"), $b.max(heights), [0.0, most]);
}
}
}
}
function numbers__usual(value, least, most) {

return !((value < least) || ((value > most) && $truth($math.isfinite(value))));
}
function usual__unusual(name, dimension, place, value, ends) {
let least, meant, most, near, remedy, small, wraps;

([least, most] = ends);
(small = ((least > 0.0) ? least : $mul(0.1, most)));
(meant = $m.join(" or ", parse__meant_by(value, dimension, small, most)));
(remedy = ($truth(meant) ? ("" + "Check the unit: " + $str(meant) + "?") : "Check the unit."));
if (($eq(dimension, "number"))) {
(near = $b.next((function* () { for (const n of $iter([0.1, 10.0, 0.01, 100.0])) { if (!((least <= $mul(n, value) && $mul(n, value) <= most))) continue; yield n; } })(), null));
(remedy = ((near == null) ? "Check the number." : ("" + "Is " + $format($mul(near, value), ("" + ".3g")) + " meant?")));
}
(wraps = $m.startswith(name, "wrap angle"));
if (($truth(wraps) && (value > most))) {
(remedy = "Is it the sum of two pulleys? Give each of them its own.");
} else {
if (($truth(wraps) && !$truth(meant))) {
(remedy = "Is it what a snub pulley adds to half a turn? Give the sum.");
}
}
if ($truth($m.startswith(name, "pressure of the belt at its rating"))) {
(remedy = "Check the diameter and the rating.");
}
if (($in(name, ["strength over the rating of the belt", "modulus over the rating of the belt"]))) {
(remedy = usual___of_rating(name, value, least));
}
if ((($eq(name, "mass of the belt")) && (value > most))) {
(remedy = "Is it that of the whole belt? Give the mass of a metre.");
}
return new Check("usual_sizes", ("" + "Usual " + $str(name)), "ATTENTION", place, value, ((value > most) ? most : least), dimension, (value > most), "sizes that conveyor drives have", "unusual size", ("" + "Unusual " + $str(check__escaped(name)) + ", {value}; {least} to {most} is usual."), check__escaped(remedy), undefined, $map([["least", [least, dimension]], ["most", [most, dimension]]]), false);
}
function parse__meant_by(value, dimension, least, most) {
let found, inside, number, short, text, unit, units, written;

(found = []);
(units = $m.get($c57, dimension, []));
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
function usual___of_rating(name, value, least) {
let meant;

if (($eq(name, "strength over the rating of the belt"))) {
if ((value < $mul(0.5, least))) {
return "Is the rating the strength? Give the tension that the belt is rated for.";
}
return ((value < least) ? "Is the rating that of the whole width? Give it per width." : "Check strength and rating: both are per width.");
}
if ((value >= least)) {
return "Check the units of both.";
}
(meant = "rating or the strength given as the modulus");
(meant = ((value < $mul(0.2, least)) ? meant : "strength given as the rating, or as the modulus"));
return ("" + "Is the " + $str(meant) + "? Check the units of both.");
}
function* usual___turning(drive, owner) {
let belt, check, dimension, ends, more, motor, name, power, pulley, radius, remedy, says, setting, speed, taken, turns, value, values;

([motor, pulley, power, speed] = [owner.of, drive.pulley($bound(owner.place, "pulley")), NaN, NaN]);
([turns, remedy] = [motor, "Check the speeds of the drums, the diameter and the belt speed."]);
if ($truth($b.isinstance(motor, Motor))) {
([power, speed] = [motor.rated_power, motor.rated_speed]);
(setting = ($truth($b.isinstance(motor, VariableSpeed)) ? motor.setting : 1.0));
(turns = ($mul(setting, speed) / motor.gear_ratio));
(remedy = "Check gear_ratio, rated_speed, diameter and belt speed.");
}
(belt = ((drive.belt.speed == null) ? NaN : drive.belt.speed));
(radius = $add(pulley.radius, $or(pitch__pitch_offset($bound(drive, "belt"), $bound(pulley, "side")), () => 0.0)));
(values = numbers__compared_motor(power, speed, turns, radius, belt));
for ([[name, dimension], value, ends] of $iter($b.zip($c60, values, $c61, $k({strict: true})))) {
if (!$truth(numbers__usual(value, ...$iter(ends)))) {
(check = usual__unusual(("" + $str(name) + " of pulley " + $str(pulley.name)), dimension, $bound(owner, "place"), value, ends));
if (($eq(name, "speed of the drum over that of the belt"))) {
(more = $b.dict($bound(check, "more")));
(more = $merged(more, $map([["drum", [$mul(turns, radius), "speed"]], ["belt", [belt, "speed"]]])));
(taken = "{drum} by the drum, which was taken, and {belt} by the speed of the belt.");
(says = ("" + $str($slice(check.says, null, $neg(1))) + ": " + $str(taken)));
(check = $replaced(check, new Map([["says", says], ["remedy", remedy], ["more", more]])));
}
yield check;
}
}
}
function numbers__compared_motor(power, speed, drum, radius, belt) {

return [power, speed, ($mul(drum, radius) / belt)];
}
function* usual___motor_sizes(drive, motors) {
let needed, pulls, rated, told;

(pulls = [...(function* () { for (const case_ of $iter(drive.load_cases)) { yield $b.abs($sub($at(case_.tensions, $at(drive.pulleys, 0).name).entry, $at(case_.tensions, $at(drive.pulleys, $neg(1)).name).exit)); } })()]);
(needed = $mul($b.max(pulls), $or(drive.belt.speed, () => NaN)));
(rated = $b.sum((function* () { for (const motor of $iter(motors)) { yield $mul(motor.count, motor.rated_power); } })()));
if (($truth(rated) && $truth(needed) && !$truth(numbers__usual((rated / needed), 0.0, 6.0)))) {
(told = "rated power of the motors over that of the largest pull");
yield usual__unusual(told, "number", $c58, (rated / needed), [0.0, 6.0]);
}
}
function* usual___conveyor_sizes(of, width) {
let dimension, ends, key, least, load, most, name, odd, slope, value;

(odd = false);
for ([value, [key, ...ends]] of $iter($b.zip(of.sizes(), $c62, $k({strict: true})))) {
([least, most] = (function* () { for (const end of $iter(ends)) { yield $mul(end, (($in(key, $c63)) ? width : 1.0)); } })());
if (!$truth(numbers__usual(value, least, most))) {
(odd = true);
(name = ("" + $str($m.replace(key, "_", " ")) + " of the conveyor"));
(dimension = $at($c64, key).dimension);
yield usual__unusual(name, dimension, $c58, value, [least, most]);
}
}
([load, slope] = [[$mul(0.7, $pow(width, 2)), $mul(700.0, $pow(width, 2))], (of.lift / of.length)]);
if (!($truth(odd) || $truth(numbers__usual($bound(of, "material"), ...$iter(load))))) {
(name = "load per length of the full belt (capacity, speed and width)");
yield usual__unusual(name, "mass_per_length", $c58, $bound(of, "material"), load);
}
if (!($truth(odd) || $truth(numbers__usual(slope, $neg(0.5), 0.5)))) {
(name = "lift over length of the conveyor");
yield usual__unusual(name, "number", $c58, slope, [$neg(0.5), 0.5]);
}
}
function* usual___law_sizes(lagging) {
let dimension, ends, friction, key, law, name, odd, of, pressures, slip, tested, value;

([tested, of] = [lagging.law.tested, ("" + "lagging " + $str(lagging.name))]);
if ((!$eq(lagging.condition, "dry"))) {
(of = $add(of, ("" + ", " + $str(lagging.condition))));
}
(odd = false);
for ([key, [name, dimension, ends]] of $iter($m.items($c66))) {
(value = $b.getattr(tested, key, null));
if (((value != null) && !$truth(numbers__usual(value, ...$iter(ends))))) {
(odd = true);
yield usual__unusual(("" + $str(name) + " of " + $str(of)), dimension, $c58, value, ends);
}
}
if ($truth(odd)) {
return null;
}
([pressures, slip] = [[100000.0], 0.01]);
if ((tested != null)) {
([pressures, slip] = [[tested.pressure_min, tested.pressure_max], tested.slip_max]);
}
(law = lagging.law.compact());
for (friction of $iter([...(function* () { for (const pressure of $iter(pressures)) { yield summary__available(law, slip, pressure); } })()])) {
if (!$truth(numbers__usual(friction, ...$iter($c67)))) {
yield usual__unusual(("" + "friction of " + $str(of)), "number", $c58, friction, $c67);
return null;
}
}
}
function* usual__unusual_sizes(drive, odd) {
let case_, dimension, least, made, most, name, names, place, pulley, size, value, values;

for (case_ of $iter(drive.load_cases)) {
for (pulley of $iter(drive.in_case(case_).pulleys)) {
(names = usual___names(pulley, case_));
(values = numbers__compared_sizes(usual__sizes_of(drive, case_, pulley)));
for ([[name, dimension, place], value, [least, most]] of $iter($b.zip(names, values, $c65, $k({strict: true})))) {
(made = $or(($in(name, ["modulus over the rating of the belt", "strength over the rating of the belt", "tension that keeps the belt from sagging"])), () => $m.startswith(name, "pressure of the belt at its rating")));
if (!($truth(numbers__usual(value, least, most)) || ($truth(made) && $truth(odd)))) {
(size = (($in(dimension, $c68)) ? drive.belt.width : 1.0));
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
return [["width of the belt", "length", belt], ["modulus of the belt", "force_per_width", belt], ["speed of the belt", "speed", belt], [("" + "diameter " + $str(of)), "length", drum], [("" + "wrap angle " + $str(of)), "angle", drum], [("" + "wrap angle " + $str(of)), "angle", drum], [("" + "creep limit " + $str(of)), "length", drum], [("" + "overrun " + $str(of)), "length", drum], [("" + "thickness " + $str(lagging)), "length", drum], [("" + "shear modulus " + $str(lagging)), "pressure", drum], [("" + "compression modulus " + $str(lagging)), "pressure", drum], ["rating of the belt", "force_per_width", belt], [("" + "bond strength " + $str(lagging)), "pressure", drum], [("" + "fatigue limit " + $str(lagging)), "pressure", drum], ["largest wrap pressure of the belt", "pressure", belt], ["least pulley of the belt", "length", belt], ["tension that keeps the belt from sagging", "force", belt], ["strength over the rating of the belt", "number", belt], ["modulus over the rating of the belt", "number", belt], [("" + $str("pressure of the belt at its rating") + " on pulley " + $str(pulley.name)), "pressure", drum], [("" + "entry tension " + $str(of)), "force", at], [("" + "exit tension " + $str(of)), "force", at], [("" + "power " + $str(of)), "power", at], ["mass of the belt", "mass_per_length", belt]];
}
function usual__sizes_of(drive, case_, pulley) {
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

return [of.width, of.modulus, of.speed, of.diameter, of.idle_wrap, of.wrap_angle, of.creep_limit, of.overrun, of.thickness, of.shear_modulus, of.compression_modulus, of.rating, of.bond_strength, of.fatigue_limit, of.face_pressure, of.least_diameter, (of.sag / of.width), (of.strength / of.rating), (of.modulus / of.rating), ($mul(2.0, of.rating) / of.diameter), (of.entry / of.width), (of.leaving / of.width), $mul($b.abs($bound(of, "pull")), of.speed), (of.mass / of.width)];
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
(worst = $b.next((function* () { for (const [kind, word] of $iter($m.items($c69))) { if (!(($in(kind, [...$iter(grounds), ...$iter(found)])))) continue; yield word; } })(), ""));
return new Check("data", "Data that the answer stands on", "OK", new Place($bound(pulley, "name")), undefined, undefined, undefined, undefined, undefined, worst, check__escaped($m.join(" ", words)), undefined, undefined, undefined, false);
}
function least_tension__least_tension(result) {
let one;

if (($truth($b.isinstance(result, TrainResult)) && $truth(result.adrift))) {
return null;
}
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
if ((!$in(one, $c70))) {
$put($c70, one, least_tension__least_of(one, $bound(one, "drive")));
}
return $at($c70, one);
}
function least_tension__least_of(result, drive) {
let either, figure, found, given, held, weight, worst;

if ($truth($b.any((function* () { for (const a of $iter(result)) { yield $and(least_tension___pulls(a), () => $math.isnan($bound(a.capacities, "gross_slip_capacity"))); } })()))) {
return null;
}
(worst = $map([]));
for (figure of $iter(least_tension__figures(result, drive))) {
(held = $m.get(worst, $bound(figure, "name")));
(either = ((held == null) ? [figure] : [held, figure]));
$put(worst, figure.name, ($truth(figure.at_least) ? alike__largest : alike__least)(either, least_tension___tension));
}
if (!$truth($b.any((function* () { for (const f of $iter($m.values(worst))) { yield $and(f.at_least, () => f.binding); } })()))) {
return null;
}
(found = new LeastTension($b.tuple($m.values(worst)), 0.0, 0.0));
if ((drive.conveyor != null)) {
(given = drive.conveyor.take_up);
} else {
(given = drive.take_up_tension(drive.load_case($bound(found.governing.place, "load_case"))));
}
(weight = drive.criteria.take_up.counterweight($bound(found, "tension")));
return new LeastTension($bound(found, "figures"), given, weight, $b.bool($bound(drive, "take_up_place")));
}
function least_tension___pulls(result) {
return !$truth(rule__idle($bound(result, "arc")));
}
function* least_tension__figures(result, drive) {
let arcs, case_, end, name;

for ([name, arcs] of $iter($m.items(least_tension___by_case(result)))) {
(case_ = result.drive.load_case(name));
(end = drive.take_up_tension(case_));
yield* $iter(least_tension___figures(result.drive.in_case(case_), case_, arcs, end));
}
if ((drive.conveyor != null)) {
yield least_tension__taut($bound(drive, "conveyor"));
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
let index, least, offset, place, result, rule, spot;

for ([index, result] of $iter($b.enumerate(arcs))) {
(spot = rules__spot_of(drive, case_, drive.pulley($bound(result.arc, "pulley")), result));
([place, offset] = [spot.place, $sub(end, spot.state.slack)]);
if ($truth(least_tension___pulls(result))) {
(least = result.capacities.least_exit_tension);
yield new Figure("creep", "Creep", $add(offset, ($truth($math.isnan(least)) ? Infinity : least)), place);
yield* $iter(least_tension___slip(result, offset, place));
yield* $iter(least_tension___standard(spot, offset));
yield least_tension___gross_slip(drive, case_, arcs, index, end);
}
for (rule of $iter($c53)) {
yield* $iter(least_tension___of_tension(rule, spot, end));
}
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
function* least_tension___standard(of, offset) {
let binding, criteria, pulley, rule, tension;
([criteria, pulley] = [of.drive.criteria, of.pulley]);
(rule = design_standard__asked($bound(criteria, "standard"), $bound(criteria, "take_up"), $bound(pulley, "lagging"), $bound(pulley, "wrap_angle")));
if ((rule == null)) {
return null;
}
([binding, tension] = [criteria.standard.binding, Infinity]);
if (!$truth($math.isnan($bound(rule, "wrap_factor")))) {
(tension = $add(offset, of_arc__design_slack(of, $bound(rule, "wrap_factor"))));
} else {
if (!($truth(binding) && $truth(criteria.standard.name))) {
return null;
}
}
yield new Figure("design_standard", $bound(rule, "rule"), tension, $bound(of, "place"), binding);
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
return $at($c71, (($eq(lagging.surface, "bare")) ? "bare" : "lagged"));
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
(found = [...(function* () { for (const d of $iter((() => $c72)())) { if (!((($eq(d.standard, name)) && ($eq(d.surface, lagging.surface))))) continue; yield d; } })()]);
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
function of_arc__design_slack(of, factor) {
let start;

(start = of_arc__start_factor($bound(of.drive, "criteria"), $bound(of.case, "kind")));
return numbers__asked_slack(factor, start, $bound($at(of.case.tensions, of.pulley.name), "effective"));
}
function of_arc__start_factor(criteria, kind) {

return (($eq(kind, "running")) ? criteria.standard.start_factor : 1.0);
}
function numbers__asked_slack(factor, start, pull) {

return $mul($mul(factor, start), $b.abs(pull));
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
function* least_tension___of_tension(rule, of, end) {
let allowed, asks, least, limit, more, now, rise, value, words;

([words, value] = [$and(rule.words, () => rule.words(of)), rule.value]);
(asks = $and(rule.tension, () => (rule.firm == null)));
if ((!$truth(asks) || (value == null) || (words == null) || $truth(words.missing))) {
return null;
}
([more, least] = [$mul(of.state.width, 1000.0), ($eq(rule.tension, "raise"))]);
(allowed = ($truth(rule.allowed) ? rule.allowed(of) : null));
(limit = rule.limited(((allowed == null) ? NaN : allowed), $bound(of, "state")));
(now = value($bound(of, "state")));
(rise = $mul(($sub(limit, now) / $sub(value(of.state.raised(more)), now)), more));
yield new Figure($bound(rule, "name"), $bound(words, "title"), $add(end, rise), $bound(of, "place"), undefined, least);
}
function least_tension__taut(conveyor) {
let ends, slackest, tension;

(ends = $map([...(function* () { for (const s of $iter(conveyor.reckoned())) { yield [s.name, $b.min($bound(s, "head"), $bound(s, "tail"), $bound(s, "entry"), $bound(s, "exit"))]; } })()]));
(slackest = alike__least(ends, ((name) => $at(ends, name))));
(tension = $add($sub(conveyor.take_up, $at(ends, slackest)), 1.0));
return new Figure("taut", "Belt taut at both ends", tension, new Place("", slackest));
}
function alike__least(items, key) {

return alike__largest(items, ((item) => $neg(key(item))));
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
function least_tension___tension(figure) {
return figure.tension;
}
function judge__sound(checks, least) {
let both, missed, names;

(missed = [...(function* () { for (const c of $iter(checks)) { if (!($truth(c.missed))) continue; yield [c.name, c.place]; } })()]);
(names = new Set((function* () { for (const [name, _] of $iter(missed)) { yield name; } })()));
(both = $and($b.bool($common(names, $c73)), () => $b.bool($common(names, $c74))));
function advised(check) {
if (($in([$m.get($c75, $bound(check, "name"), ""), check.place], missed))) {
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
if (!$truth(rule__idle($bound(arc, "arc")))) {
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
function least_tension__least_sentence(result) {
let as_now, asked, described, found, given, governs, least, standard, text, what, why;

(found = least_tension__least_tension(result));
if ((found == null)) {
return "";
}
([least, given] = [least_tension__at_least($bound(found, "tension")), sheet__named("tension", $bound(found, "given"))]);
(governs = found.governing);
(why = $at($c76, governs.name).what);
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
return ("" + "No " + $str(least_tension__least_name(result)) + " with wrap pressures in the tested range keeps " + $str($at($c76, governs.name).what) + " (" + $str(governs.place) + ").");
}
([asked, most] = [least_tension__at_least($bound(governs, "tension")), least_tension__at_most($bound(top, "tension"))]);
return ("" + "No " + $str(least_tension__least_name(result)) + " keeps every binding check: " + $str($at($c76, governs.name).what) + " asks for " + $str(asked) + " (" + $str(governs.place) + "), and " + $str($at($c76, top.name).what) + " allows " + $str(most) + " (" + $str(top.place) + ").");
}
function least_tension__least_name(result) {

return least_tension__tension_at(least_tension___place(result));
}
function least_tension___place(result) {
let one;
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
return one.drive.take_up_place;
}
function least_tension__tension_at(place) {

return ($truth(place) ? ("" + "tension " + $str(place)) : "slack-side tension");
}
function least_tension__at_most(tension) {

return cellOf(tension, "force", 3, "down", undefined, "tension");
}
function least_tension__divides_anew(result) {

return $and($b.isinstance(result, TrainResult), () => !$truth($b.all((function* () { for (const c of $iter(result)) { yield c.case.pulls_given; } })())));
}
function least_tension__least_table(result) {
let bound, figure, found, given, governs, least, note, place, rows, shown, symbol, text, weight, where;

(found = least_tension__least_tension(result));
if ((found == null)) {
return null;
}
([rows, place] = [[], least_tension___place(result)]);
if (!$truth($math.isinf($bound(found, "tension")))) {
(weight = cellOf($bound(found, "counterweight"), "mass", 3, "up"));
(given = ("" + "given " + $str(sheet__named("tension", $bound(found, "given")))));
(least = least_tension__at_least($bound(found, "tension")));
(symbol = ($truth(place) ? "" : "T2_min"));
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
(where = $or(place, () => "of the slack side behind the drives"));
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
return ($truth(rule__idle($bound(arc, "arc"))) ? "not driven" : "carries");
}
function drive_sheet__summary_table(results) {
let arc, brakes, heads, method, result, rows, title;

(brakes = $b.any((function* () { for (const result of $iter(results)) { for (const arc of $iter(result)) { yield (arc.arc.side < 0.0); }} })()));
(heads = [sheet__headed("T1", "force"), sheet__headed("T2", "force"), "T1/T2", sheet__headed("creep", "length"), "of limit", sheet__headed(($truth(brakes) ? "least slack" : "least T2"), "force"), ""]);
(rows = []);
for (result of $iter(results)) {
for (arc of $iter(result)) {
(method = (($b.len(results) > 1) ? ("" + ", " + $str($at($c77, arc.method))) : ""));
(title = ("" + $str(arc.arc.load_case) + ": " + $str(arc.arc.pulley) + $str(method)));
$m.append(rows, new Row(title, drive_sheet___summary_values(result, arc), undefined, undefined, undefined, words__level_of(result, arc)));
}
}
return new Table("All load cases and pulleys", $b.tuple(rows), heads, undefined, "cases");
}
function sheet__headed(words, dimension) {

return (($eq(dimension, "number")) ? words : ("" + $str(words) + " [" + $str(cell__unit_of(dimension)) + "]"));
}
function cell__unit_of(dimension) {

return cellOf(0.0, dimension, undefined, "unit");
}
function drive_sheet___summary_values(of, result) {
let arc, creep;
([arc, creep] = [result.arc, result.exit_creep]);
return [sheet__number("entry_tension", $bound(arc, "entry_tension")), sheet__number("exit_tension", $bound(arc, "exit_tension")), sheet__number("tension_ratio", (arc.entry_tension / arc.exit_tension)), sheet__number("exit_creep", creep), cell__percent(($b.abs(creep) / arc.creep_limit)), drive_sheet___least(of, result), words__short(of, result)];
}
function sheet__number(name, value) {

return cell__bare(value, $bound(term(name), "dimension"), 3, name);
}
function cell__bare(value, dimension, digits = 3, name = "") {

if (!$truth($math.isfinite(value))) {
return cell__quantity(value, dimension);
}
return cellOf(value, dimension, digits, "bare", undefined, name);
}
function drive_sheet___least(of, result) {
let found;

if (($b.len($bound(of.drive, "pulleys")) > 1)) {
return "-";
}
(found = least_tension__least_tension(words__alone_of(of, result)));
if ((found == null)) {
return "-";
}
if ($truth($math.isinf($bound(found, "tension")))) {
return "none";
}
return cellOf($bound(found, "tension"), "force", 3, "bare up", undefined, "tension");
}
function words__alone_of(result, arc) {
let known;

(known = $m.setdefault($c78, result, $map([])));
if ((!$in(arc, known))) {
$put(known, arc, words__alone($bound(result, "drive"), arc));
}
return $at(known, arc);
}
function words__alone(drive, arc) {
let case_, criteria, name, own, own_case, pulley, solved, take_up, tensions;

([name, solved] = [arc.arc.load_case, arc.arc]);
(tensions = new Tensions(solved.entry_tension, solved.exit_tension));
(own = $b.next((function* () { for (const case_ of $iter(drive.load_cases)) { if (!(($eq(case_.name, name)))) continue; yield case_; } })(), null));
(case_ = new LoadCase(name, $map([[arc.arc.pulley, tensions]]), ($truth(own) ? own.kind : "running"), ($truth(own) ? own.condition : "")));
(pulley = drive.pulley($bound(arc.arc, "pulley")));
([criteria, take_up] = [drive.criteria, drive.criteria.take_up]);
if ((!$in(take_up.after, ["", pulley.name]))) {
(criteria = $replaced(criteria, new Map([["take_up", $replaced(take_up, new Map([["after", ""]]))]])));
}
(own_case = $replaced(drive, new Map([["criteria", criteria], ["pulleys", [pulley]], ["load_cases", [case_]], ["conveyor", null]])));
return new DriveResult(own_case, [arc]);
}
function words__level_of(result, arc) {

return judge__judge(result).at($bound(arc.arc, "pulley"), $bound(arc.arc, "load_case")).level;
}
function drive_sheet__arc_tables(result, results, of) {
let carried, case_, drive, first, found, lagging, solved;

([first, drive] = [$at(results, 0), result.drive]);
(case_ = drive.load_case($bound(first.arc, "load_case")));
(lagging = drive.pulley($bound(first.arc, "pulley")).lagging_in($bound(case_, "condition")));
(solved = $b.tuple((function* () { for (const other of $iter(results)) { if (!($truth($told($c40, other.status, "solved")))) continue; yield other; } })()));
(carried = $told($c40, first.status, "solved"));
(found = $map([["answer", ($truth(solved) ? arc_tables__answer_table(solved) : null)], ["creep", ($truth(solved) ? arc_tables__creep_table(solved) : null)], ["capacity", arc_tables__capacity_table(first)], ["margins", in_page_checks__no_table(result, first)], ["comparison", design_values__comparison_table(first, lagging, of)], ["energy", ($truth(carried) ? arc_tables__energy_table(first) : null)], ["loads", drive_sheet__loads_table(new DriveResult(drive, [first]))], ["wear", ($truth(carried) ? in_page_checks__no_table(first, lagging) : null)], ["life", ($truth(carried) ? wear_table__life_table(first, lagging, of) : null)], ["inputs", input_tables__input_table(drive, $bound(first, "arc"), of)]]));
return $map([...(function* () { for (const [key, table] of $iter($m.items(found))) { if (!((table != null))) continue; yield [key, table]; } })()]);
}
function arc_tables__answer_table(results) {
let first, g, level, limit, note, notes, pressure, rows, share, sides, told, where;

function row(name, note = "", level = null) {
let values;
(values = (function* () { for (const result of $iter(results)) { yield $b.getattr(result, name); } })());
return $call(sheet__row_of, [name, ...$iter(values)], [["note", note], ["level", level]]);
}
$sig(row, ["name", "note", "level"], false);
(first = $at(results, 0));
(limit = first.arc.creep_limit);
(share = ("" + $str(cell__percent(($b.abs($bound(first, "exit_creep")) / limit))) + " of the limit"));
(notes = [("" + $str(share) + ", " + $str(sheet__named("creep_limit", limit)))]);
(notes = $add(notes, ((first.exit_creep < 0.0) ? ["negative: with the belt"] : [])));
(notes = $add(notes, ($truth((told = arc_tables__creep_interval_text(first))) ? [told] : [])));
([level, sides] = [arc_tables___creep_level(first), new Set((function* () { for (const r of $iter(results)) { if (!($truth($told($c40, r.status, "solved")))) continue; yield r.within_creep_limit; } })())]);
if (($b.len(sides) > 1)) {
$m.append(notes, "the methods stand on different sides of it");
(level = ((level === "OK") ? "ATTENTION" : level));
}
(where = ("" + "at " + $str(sheet__named("peak_shear_position", $bound(first, "peak_shear_position"))) + " from the entry"));
(pressure = new Row("Wrap pressure, entry to exit", arc_tables___values(results, arc_tables___pressures), "p"));
(rows = [row("exit_creep", $m.join("; ", notes), level), row("exit_slip"), row("peak_shear_angle", where), row("peak_shear_stress"), pressure, row("mean_friction", "equivalent constant friction over the whole wrap"), row("active_arc", "exit part over which 99 % of the tension change takes place"), ...$iter((!$truth($math.isnan($bound(first, "k_factor"))) ? [row("k_factor", "belt modulus x width / active arc (equation 7 of the paper)")] : []))]);
if ($truth($b.any((function* () { for (const result of $iter(results)) { yield result.sticks; } })()))) {
$m.append(rows, row("stuck_arc", "entry part where the belt does not slip"));
}
if (!$truth($b.all((function* () { for (const result of $iter(results)) { yield $math.isnan($bound(result, "outside_tested_share")); } })()))) {
$m.append(rows, arc_tables___outside_row(results));
}
if (($eq($b.len(results), 1))) {
(g = ("" + $str(cell__percent($bound(first, "entry_creep_ratio"))) + " to " + $str(cell__percent($bound(first, "exit_creep_ratio")))));
(note = "belt slower than the lagging surface, entry to exit");
if ((first.exit_creep_ratio < 0.0)) {
(note = "negative: belt faster than the lagging surface, entry to exit");
}
$m.append(rows, new Row("Creep ratio", [g], "g", note));
}
return new Table(("" + "Result: " + $str(arc_tables__belongs(first))), $b.tuple(rows), arc_tables__heads(results), undefined, "result");
}
function sheet__row_of(name, ...values) {
let cells, entry;
const {note: note = "", title: title = "", level: level = null} = $named(values);

(entry = term(name));
(cells = $b.tuple((function* () { for (const value of $iter(values)) { yield sheet__named(name, value); } })()));
return new Row($or(title, () => entry.title), cells, $bound(entry, "symbol"), note, name, level);
}
function arc_tables__creep_interval_text(result) {
let end, high, low;

([low, high] = result.creep_interval);
if ($truth($math.isnan(low))) {
return "";
}
if (($truth($math.isinf(high)) || $truth($math.isinf(low)))) {
(end = ($truth($math.isinf(high)) ? low : high));
return ("" + "95 % by the law: from " + $str(sheet__named("exit_creep", end)) + " to gross slip");
}
return ("" + "95 % by the law: " + $str(sheet__between("exit_creep", low, high)));
}
function sheet__between(name, first, last, form = "to") {

return cellOf(last, $bound(term(name), "dimension"), 3, form, first, name);
}
function arc_tables___creep_level(result) {
if (!$truth($told($c40, result.status, "solved"))) {
return null;
}
return ($truth(result.within_creep_limit) ? "OK" : "ATTENTION");
}
function arc_tables___pressures(result) {
let arc, first, last;
(arc = result.arc);
([first, last] = [arc.wrap_pressure($bound(result, "entry_tension")), arc.wrap_pressure($bound(result, "exit_tension"))]);
return sheet__between("wrap_pressure", first, last);
}
function arc_tables___values(results, of) {
return $b.tuple((function* () { for (const result of $iter(results)) { yield of(result); } })());
}
function arc_tables___outside_row(results) {
let level, note, outside, texts, title;
(texts = arc_tables___values(results, ((r) => ("" + $str(cell__percent($bound(r, "outside_tested_share"))) + " of the wrap"))));
(outside = $b.any((function* () { for (const result of $iter(results)) { yield result.extrapolates; } })()));
(note = ($truth(outside) ? "the friction law is an extrapolation there" : ""));
(level = ($truth(outside) ? "ATTENTION" : null));
(title = sheet__row_of("outside_tested_share", 0.0).title);
return new Row(title, texts, "", note, "outside_tested_share", level);
}
function arc_tables__belongs(result) {

return ("" + "pulley " + $str(result.arc.pulley) + ", load case " + $str(result.arc.load_case));
}
function arc_tables__heads(results) {

if ((($eq($b.len(results), 1)) && ($eq($at(results, 0).method, "distributed")))) {
return [""];
}
return $b.tuple((function* () { for (const r of $iter(results)) { yield $m.get($c77, $bound(r, "method"), $bound(r, "method")); } })());
}
function arc_tables__creep_table(results) {
let name, note, row, rows, texts;

(rows = []);
for ([name, note] of $iter([["creep_shrinkage", "the belt sheds tension and shortens"], ["creep_compression", "the lagging is squeezed at the entry and recovers"], ["creep_global", "the whole belt slips back: what the friction needs beyond the first two"]])) {
(texts = arc_tables___values(results, ((r) => arc_tables__creep_part(r, name))));
(row = sheet__row_of(name, 0.0));
$m.append(rows, new Row($bound(row, "title"), texts, $bound(row, "symbol"), note, name));
}
$m.append(rows, sheet__row_of("exit_creep", ...$iter((function* () { for (const r of $iter(results)) { yield r.exit_creep; } })())));
return new Table("Creep by source", $b.tuple(rows), arc_tables__heads(results), undefined, "creep");
}
function arc_tables__creep_part(result, name) {
let part, parts;

(part = $b.getattr(result, name));
(parts = [result.creep_shrinkage, result.creep_compression, result.creep_global]);
if (($b.sum($b.map($b.abs, parts)) > $mul(1.05, $b.abs($bound(result, "exit_creep"))))) {
return sheet__named(name, part);
}
return ("" + $str(sheet__named(name, part)) + " (" + $str(cell__percent((part / result.exit_creep), 2)) + ")");
}
function arc_tables__capacity_table(result) {
let actual, arc, c, gross, held, note, ratio_now, rows, slack, slip, tight;

([c, arc] = [result.capacities, result.arc]);
if (($truth($math.isnan($bound(c, "gross_slip_capacity"))) && $truth($math.isnan($bound(c, "creep_limit_capacity"))))) {
return null;
}
([tight, slack] = ((arc.side > 0.0) ? ["T1", "T2"] : ["T2", "T1"]));
(held = sheet__named("tension", $b.max($bound(arc, "entry_tension"), $bound(arc, "exit_tension"))));
(ratio_now = (arc.entry_tension / arc.exit_tension));
(actual = $b.max(ratio_now, (1.0 / ratio_now)));
function row(name, value, note) {
return new Row($bound(term(name), "title"), [sheet__named(name, value)], $bound(term(name), "symbol"), note, name);
}
$sig(row, ["name", "value", "note"], false);
function ratio(name, value, margin, note) {
let shown;
(shown = ($truth($math.isnan(margin)) ? "" : ("" + "margin " + $str(sheet__named("tension_ratio", margin)) + "; ")));
return row(name, value, ("" + $str(shown) + $str(note)));
}
$sig(ratio, ["name", "value", "margin", "note"], false);
(rows = [ratio("creep_limit_capacity", $bound(c, "creep_limit_capacity"), $bound(c, "creep_limit_margin"), "the design number"), row("equivalent_friction", $bound(c, "equivalent_friction"), "compare with design values")]);
if ((arc.law.tested != null)) {
(slip = sheet__named("slip", $bound(arc.law.tested, "slip_max")));
(note = ("" + "slip at the largest tested, " + $str(slip)));
$m.append(rows, ratio("tested_slip_capacity", $bound(c, "tested_slip_capacity"), $bound(c, "tested_slip_margin"), note));
}
(gross = arc_tables___gross_note(arc_tables__independent_of_slip($bound(arc, "law")), $bound(c, "gross_slip_creep")));
$m.append(rows, row("gross_slip_capacity", $bound(c, "gross_slip_capacity"), gross));
(note = ("" + "Ratios " + $str(tight) + "/" + $str(slack) + " with " + $str(tight) + " held at " + $str(held) + "; margin is the capacity over the actual ratio, " + $str(sheet__named("tension_ratio", actual)) + "."));
return new Table("Capacity", $b.tuple(rows), undefined, note, "capacity");
}
function arc_tables__independent_of_slip(law) {

return $b.isinstance(law, Constant, PressurePower);
}
function arc_tables___gross_note(plain, creep) {
if ($truth(plain)) {
return "the whole wrap slips";
}
if ($truth($math.isinf(creep))) {
return "extrapolated, approached as creep grows without bound";
}
return ("" + "extrapolated, at " + $str(sheet__named("gross_slip_creep", creep)) + " of creep");
}
function in_page_checks__no_table(..._of) {

}
function design_values__comparison_table(result, lagging, of) {
let arc, asked, c, given, heads, limit, mean, note, ratio, ratio_head, rows;

([arc, c] = [result.arc, result.capacities]);
(given = $b.min($bound(arc, "entry_tension"), $bound(arc, "exit_tension")));
(ratio = ($b.max($bound(arc, "entry_tension"), $bound(arc, "exit_tension")) / given));
(mean = ($math.log(ratio) / arc.wrap_angle));
(asked = design_values___texts(mean, ratio, given, ($truth(mean) ? arc.wrap_angle : 0.0)));
(rows = [new Row("This load, whole wrap slipping", asked)]);
if (!$truth($math.isnan($bound(c, "equivalent_friction")))) {
(limit = design_values___texts($bound(c, "equivalent_friction"), $bound(c, "creep_limit_capacity"), $bound(c, "least_exit_tension"), NaN));
$m.append(rows, new Row("At the creep limit, as computed", limit));
}
(rows = $add(rows, [...(function* () { for (const classical of $iter(design_values__known(result, lagging))) { yield design_values___design_row(classical, result, of); } })()]));
if ($truth(lagging.surface)) {
(note = "Slack side: Cw (T1 - T2) with Cw = 1/(exp(mu phi) - 1). Slipping arc: ln(T1/T2)/mu. Design values are constant and take no account of creep.");
} else {
(note = "The surface of the lagging is not given, so no design values apply.");
}
(ratio_head = ((arc.side > 0.0) ? "T1/T2 up to" : "T2/T1 up to"));
(heads = ["friction", ratio_head, "slack side", "slipping arc"]);
return new Table("Compared with constant friction", $b.tuple(rows), heads, note, "constant");
}
function design_values___texts(mu, ratio, slack, arc) {
return [cell__quantity(mu, "number"), sheet__named("tension_ratio", ratio), sheet__named("tension", slack), sheet__named("active_arc", arc)];
}
function design_values__known(result, lagging) {

return constant_friction__classical_drives($bound(result, "arc"), lagging);
}
function constant_friction__classical_drives(arc, lagging) {
let known;

(known = [...(function* () { for (const value of $iter((() => $c72)())) { if (!(($eq(value.surface, lagging.surface)))) continue; yield value; } })()]);
known.splice(0, Infinity, ...$b.sorted(known, $k({key: ((value) => (!$in(value.condition, ["", lagging.condition])))})));
return $b.tuple((function* () { for (const value of $iter(known)) { yield constant_friction___classical(arc, value); } })());
}
function constant_friction___classical(arc, value) {
let factors, high, low, phi, pull, ratio;
([low, high] = value.friction);
([phi, pull] = [arc.wrap_angle, $b.abs($bound(arc, "effective_tension"))]);
(ratio = (arc.entry_tension / arc.exit_tension));
(factors = [constant_friction__wrap_factor(low, phi), constant_friction__wrap_factor(high, phi)]);
return new ClassicalDrive(value, [constant_friction__capstan_ratio(low, phi), constant_friction__capstan_ratio(high, phi)], factors, [$mul($at(factors, 0), pull), $mul($at(factors, 1), pull)], [constant_friction__slipping_arc(low, ratio), constant_friction__slipping_arc(high, ratio)]);
}
function constant_friction__capstan_ratio(friction, wrap_angle) {

return $math.exp($mul(friction, wrap_angle));
}
function constant_friction__slipping_arc(friction, tension_ratio) {

return ($b.abs($math.log(tension_ratio)) / friction);
}
function design_values___design_row(drive, result, of) {
let arc, design, high, low, note, slips, standard, title, values;
([design, arc] = [drive.design, result.arc]);
(standard = $add($m.upper($at(design.standard, 0)), $slice(design.standard, 1, null)));
(slips = ($at(drive.slipping_arc, 0) > arc.wrap_angle));
([low, high] = design.friction);
(values = [(($eq(low, high)) ? ("" + $format(low, ("" + ".2f"))) : ("" + $format(low, ("" + ".2f")) + "-" + $format(high, ("" + ".2f")))), design_values___pair("tension_ratio", $bound(drive, "ratio")), design_values___pair("tension", $bound(drive, "slack_tension")), ($truth(slips) ? "gross slip" : design_values___pair("active_arc", $bound(drive, "slipping_arc")))]);
(note = of.note($bound(design, "provenance")));
(title = $m.join(", ", (function* () { for (const part of $iter([standard, design.surface, design.condition])) { if (!($truth(part))) continue; yield part; } })()));
return new Row(title, values, undefined, note, undefined, ($truth(slips) ? "ATTENTION" : null));
}
function design_values___pair(name, ends) {
return $call(sheet__between, [name, ...$iter(ends)], [["form", "-"]]);
}
function arc_tables__energy_table(result) {
let e, entry, needs, note, rows;

(e = result.energy);
(rows = [...(function* () { for (const name of $iter(["transmitted_power", "sliding_power", "shear_loss", "power_loss"])) { if (!(!$truth($math.isnan($b.getattr(e, name))))) continue; yield sheet__row_of(name, $b.getattr(e, name)); } })()]);
if (!$truth($math.isnan($bound(e, "efficiency")))) {
(entry = sheet__row_of("efficiency", 0.0));
$m.append(rows, new Row($bound(entry, "title"), [cell__percent($bound(e, "efficiency"), 4)], $bound(entry, "symbol"), "", "efficiency"));
}
(note = "what wears lagging and belt");
$m.append(rows, $call(sheet__row_of, ["frictional_energy", $bound(e, "frictional_energy")], [["note", note]]));
if (!$truth($math.isnan($bound(e, "wear_rate")))) {
$m.append(rows, sheet__row_of("wear_rate", $bound(e, "wear_rate")));
}
(needs = ($truth(result.arc.belt_speed) ? "" : "Give the belt speed to see powers."));
return new Table("Energy and wear", $b.tuple(rows), undefined, needs, "energy");
}
function drive_sheet__loads_table(result) {
let arc, belt, cells, drive, given, heads, note, of, rows, shown, strength, weighed;

([drive, belt, rows] = [result.drive, result.drive.belt, []]);
(weighed = [...(function* () { for (const p of $iter(drive.pulleys)) { if (!($truth(p.mass))) continue; yield ("" + $str(p.name) + " " + $str(cell__quantity($bound(p, "mass"), "mass", 4))); } })()]);
(strength = ((belt.breaking_strength == null) ? NaN : belt.breaking_strength));
for (arc of $iter(result)) {
(of = drive_sheet__loads_of(drive, $bound(arc, "arc")));
(cells = [sheet__named("resultant_force", $bound(of, "resultant_force")), sheet__named("resultant_angle", $bound(of, "resultant_angle")), sheet__named("belt_safety", $bound(of, "belt_safety")), sheet__named("most_shaft_load", $bound(of, "most_shaft_load")), sheet__named("least_shaft_load", $bound(of, "least_shaft_load"))]);
$m.append(rows, new Row(("" + $str(arc.arc.load_case) + ": " + $str(arc.arc.pulley)), $slice(cells, null, ($truth(weighed) ? 5 : 3))));
}
(note = "Resultant of the belt tensions for shaft and bearings, from the line of T1 towards that of T2, the weight of the pulley left out. ");
if ($truth(weighed)) {
(note = $add(note, ("" + "With the weight (" + $str($m.join(", ", weighed)) + "): most where the belt pulls straight down, least where it pulls straight up; where it pulls level, the root of the sum of both squares. ")));
}
if ((belt.breaking_strength == null)) {
(note = $add(note, "Safety factor of the belt: its strength is not given."));
} else {
(given = cell__quantity(strength, "force_per_width", 4));
(note = $add(note, ("" + "Safety factor: strength " + $str(given) + " over the larger tension; see the checks.")));
}
(heads = ["resultant", "direction", "belt", "with weight, most", "least"]);
(shown = $slice(heads, null, ($truth(weighed) ? 5 : 3)));
return new Table("Loads of pulleys and belt", $b.tuple(rows), shown, note, "loads");
}
function drive_sheet__loads_of(drive, of) {
let known, mass, strength;

([strength, mass] = [drive.belt.breaking_strength, drive.pulley($bound(of, "pulley")).mass]);
(known = [((strength == null) ? NaN : $mul(strength, of.width)), $or(mass, () => NaN)]);
return load_case__resultant($bound(of, "entry_tension"), $bound(of, "exit_tension"), $bound(of, "wrap_angle"), ...$iter(known));
}
function wear_table__life_table(result, lagging, of = null) {
let data, depth, k, life, note, passes, rows, source, years;

(data = wear_table___life_of(result, lagging));
if ((data == null)) {
return null;
}
(passes = cell__quantity($at(data, "passes_per_hour"), "number"));
(rows = [new Row("Passes of the lagging under the belt", [("" + $str(passes) + " 1/h")])]);
(depth = cell__quantity($at(data, "depth"), "length"));
if (($at(data, "life_hours") != null)) {
(k = cell__quantity($at(data, "coefficient"), "wear_coefficient"));
(source = $b.str(lagging.source_of("wear_coefficient")));
$m.append(rows, new Row("Wear coefficient", [k], undefined, source));
(life = wear_table___life($at(data, "life_hours")));
(years = ("" + "frictional energy times wear coefficient; a year has " + $format(6000.0, ("" + "g")) + " h of running here"));
$m.append(rows, new Row(("" + "Life until " + $str(depth) + " is worn off"), [life], undefined, years));
}
(rows = $add(rows, [...(function* () { for (const vendor of $iter($at(data, "vendors"))) { yield wear_table___vendor_row(vendor, of); } })()]));
(note = ("" + "Depth that may be worn off: half the thickness, " + $str(depth) + "."));
if (($at(data, "life_hours") == null)) {
(note = $add(note, " The life follows from a wear coefficient, which nobody publishes: calibrate it to a measured wear (wraparc field --measured-wear), or give wear_coefficient."));
}
return new Table("Life of the lagging", $b.tuple(rows), undefined, note, "life");
}
function wear_table___life_of(result, lagging) {
let depth, energy, k, passes, speed;
([speed, depth] = [result.arc.belt_speed, $mul(0.5, lagging.thickness)]);
(energy = $b.abs($bound(result.energy, "frictional_energy")));
if (((speed == null) || !$truth($told($c40, result.status, "solved")) || (depth <= 0.0) || !(energy > 1e-09))) {
return null;
}
(passes = pitch__turns_an_hour(speed, $add(result.arc.radius, result.arc.offset)));
(k = lagging.wear_coefficient);
return $map([["passes_per_hour", passes], ["frictional_energy", energy], ["belt_energy_share", lagging.belt_energy_share], ["depth", depth], ["coefficient", k], ["life_hours", ((k == null) ? null : wear__wear_life(depth, k, energy, passes))], ["vendors", $b.list(wear_table___vendors(lagging, depth, energy, passes))]]);
}
function pitch__turns_an_hour(speed, pitch) {

return ($mul(3600.0, speed) / $mul($mul(2.0, 3.141592653589793), pitch));
}
function wear__wear_life(depth, coefficient, energy, passes) {
let worn;

(worn = $mul($mul(coefficient, $b.abs(energy)), passes));
return ((worn > 0.0) ? (depth / worn) : Infinity);
}
function* wear_table___vendors(lagging, depth, energy, passes) {
let ends, high, low, row;
for (row of $iter((() => $c79)())) {
if (($eq(row.surface, lagging.surface))) {
([low, high] = row.life_years);
(ends = (function* () { for (const y of $iter([high, low])) { yield wear__coefficient_of_life(depth, $mul(6000.0, y), energy, passes); } })());
yield $map([["name", row.name], ["years", [low, high]], ["coefficient", $b.list(ends)], ["source", $b.str($bound(row, "provenance"))]]);
}
}
}
function wear__coefficient_of_life(depth, hours, energy, passes) {
let worn;

(worn = $mul($mul(hours, $b.abs(energy)), passes));
return ((worn > 0.0) ? (depth / worn) : Infinity);
}
function wear_table___life(hours) {
if ($truth($math.isinf(hours))) {
return "-";
}
return $add(cell__quantity(hours, "number"), " h");
}
function wear_table___vendor_row(vendor, of) {
let ends, high, least, low, most, note, number, years;
([low, high] = $at(vendor, "coefficient"));
(ends = cellOf(high, "wear_coefficient", 3, "to", low));
([least, most] = $at(vendor, "years"));
(years = (($eq(least, most)) ? ("" + "over " + $format(least, ("" + "g"))) : ("" + $format(least, ("" + "g")) + " to " + $format(most, ("" + "g")))));
(number = ((of == null) ? "" : of.number(("" + $str("life of a lagging as its vendor states it") + ": " + $str($at(vendor, "source"))))));
(note = ("" + "whatever the creep; here it would take a wear coefficient of " + $str(ends) + " " + $str(number)));
return new Row(("" + "Vendor's life, " + $str($at(vendor, "name"))), [("" + $str(years) + " years")], undefined, $m.strip(note));
}
function input_tables__input_table(drive, arc, of) {
let title;

(title = ("" + "Inputs: pulley " + $str(arc.pulley) + ", load case " + $str(arc.load_case)));
return new Table(title, input_tables__input_rows(inputs__arc_inputs(drive, arc), of), undefined, undefined, "inputs");
}
function inputs__arc_inputs(drive, arc) {
let group, pull, pulley, ratio;

(pulley = drive.pulley($bound(arc, "pulley")).in_condition($bound(drive.load_case($bound(arc, "load_case")), "condition")));
([pull, ratio] = [arc.effective_tension, (arc.entry_tension / arc.exit_tension)]);
(group = ("" + "Load case " + $str(arc.load_case)));
return [...$iter(inputs__belt_inputs($replaced(drive.belt, new Map([["speed", arc.belt_speed]])))), ...$iter(inputs___pulley(drive, pulley, $bound(arc, "entry_overrun"))), ...$iter(inputs__lagging_inputs($bound(pulley, "lagging"))), ...$iter(inputs___tensions(drive, arc)), inputs___named(group, "effective_tension", pull, null, $bound(arc, "duty")), inputs___named(group, "tension_ratio", ratio, null)];
}
function* inputs__belt_inputs(belt) {
let group, key, least, most, name, origin_of, shear;

(group = "Belt");
function origin(key) {
return $m.get(belt.sources, key, $bound(belt, "provenance"));
}
$sig(origin, ["key"], false);
function own(title, value, dimension, key) {
return new Input(group, title, value, dimension, "", origin(key));
}
$sig(own, ["title", "value", "dimension", "key"], false);
(name = ($truth(belt.kind) ? ("" + $str(belt.name) + " (" + $str(belt.kind) + ")") : belt.name));
yield new Input(group, "Belt", name, undefined, undefined, belt.provenance);
yield inputs___named(group, "belt_width", $bound(belt, "width"), origin("width"));
yield inputs___named(group, "belt_modulus", $bound(belt, "modulus"), origin("modulus"));
yield inputs___named(group, "axial_stiffness", $bound(belt, "axial_stiffness"), null, "M B");
yield own("Rating of the belt", $bound(belt, "rating"), "force_per_width", "rating");
if ((belt.breaking_strength != null)) {
yield own("Breaking strength", $bound(belt, "breaking_strength"), "force_per_width", "strength");
}
([least, most] = [belt.least_pulley_diameter, belt.largest_wrap_pressure]);
yield own("Least drive pulley", least, "length", "least_pulley_diameter");
yield own("Largest wrap pressure", most, "pressure", "largest_wrap_pressure");
yield own("Momentary tension over rating", $bound(belt, "momentary_factor"), "number", "momentary_factor");
yield inputs___named(group, "belt_speed", $bound(belt, "speed"), origin("speed"));
(shear = belt.in_plane_shear_stiffness);
if ((shear != null)) {
(origin_of = origin("in_plane_shear_stiffness"));
yield inputs___named(group, "in_plane_shear_stiffness", shear, origin_of);
}
for (key of $iter([...$iter($c6), "thickness", "cover_shear_modulus", "mass"])) {
if (($b.getattr(belt, key) != null)) {
(name = $m.get($map([["thickness", "belt_thickness"], ["mass", "belt_mass"]]), key, key));
yield inputs___named(group, name, $b.getattr(belt, key), origin(key));
}
}
if (($truth(pitch__covered(belt)) && (belt.cover_shear_modulus == null))) {
yield inputs___named(group, "cover_shear_modulus", 1000000.0, $c80);
}
}
function inputs___named(group, name, value, origin, remark = "") {
let entry;
(entry = term(name));
return new Input(group, $bound(entry, "title"), value, $bound(entry, "dimension"), $bound(entry, "symbol"), origin, remark, name);
}
function* inputs___pulley(drive, pulley, overrun = null) {
let by_formula, conditions, group, known, lagging, limit, offset, side, title;

(group = ("" + "Pulley " + $str(pulley.name)));
function origin(key) {
return $m.get(pulley.sources, key, $c81);
}
$sig(origin, ["key"], false);
yield inputs___named(group, "diameter", $bound(pulley, "diameter"), origin("diameter"));
yield inputs___named(group, "wrap_angle", $bound(pulley, "wrap_angle"), origin("wrap_angle"));
([offset, side] = [pitch__pitch_offset($bound(drive, "belt"), $bound(pulley, "side")), ("" + $str(pulley.side) + " side of the belt")]);
if ((offset != null)) {
yield inputs___named(group, "pitch_offset", offset, null, side);
} else {
if ((!$eq(pulley.side, "pulley"))) {
yield new Input(group, "Meets the", side, undefined, undefined, origin("side"));
}
}
if ((pulley.mass != null)) {
yield inputs___named(group, "pulley_mass", $bound(pulley, "mass"), origin("mass"));
}
if ((pulley.overrun != null)) {
yield inputs___named(group, "overrun", $bound(pulley, "overrun"), origin("overrun"));
} else {
(by_formula = inputs___named(group, "overrun", overrun, null, "from the compression of the lagging, 1.25 delta sqrt(delta/R)"));
yield ((overrun != null) ? by_formula : $replaced(by_formula, new Map([["value", "by formula"]])));
}
if (!$truth(pulley.recovery)) {
yield new Input(group, "Recovery of the lagging", "not counted", undefined, undefined, origin("recovery"));
}
(limit = drive.creep_limit_of(pulley));
(known = (($eq(limit, 0.00635)) ? $c82 : $c81));
yield inputs___named(group, "creep_limit", limit, $m.get(pulley.sources, "creep_limit", known));
(conditions = (function* () { for (const lagging of $iter($or(pulley.conditions, () => [pulley.lagging]))) { yield lagging.condition; } })());
([lagging, title] = [("" + $str(pulley.lagging.name) + " (" + $str($m.join(", ", conditions)) + ")"), pulley.lagging.title]);
yield new Input(group, "Lagging", lagging, undefined, undefined, origin("lagging"), title);
yield* $iter(inputs___across(pulley, origin));
}
function* inputs___across(pulley, origin) {
let across, dimension, group, key, profile, remark, rows, size, skew, title;

([across, group] = [pulley.across, ("" + "Pulley " + $str(pulley.name))]);
if ((across == null)) {
return null;
}
for ([key, profile] of $iter($m.items(across.profiles()))) {
(title = $m.capitalize($m.replace(key, "_", " ")));
(dimension = (($eq(key, "entry_profile")) ? "force_per_width" : "length"));
(rows = ("" + "largest less least of " + $str($b.len($bound(profile, "position"))) + " places"));
(size = ($truth(profile.value) ? $sub($b.max($bound(profile, "value")), $b.min($bound(profile, "value"))) : profile.crown));
(remark = ($truth(profile.value) ? rows : "crown, on radius"));
yield new Input(group, title, size, dimension, "", origin("across"), remark);
}
if ($truth(across.misalignment)) {
(skew = $mul(1000.0, across.misalignment));
yield new Input(group, "Misalignment", ("" + $format(skew, ("" + "g")) + " mm/m"), undefined, undefined, origin("across"));
}
if ($truth(across.deflection)) {
yield new Input(group, "Shaft deflection", $bound(across, "deflection"), "length", "", origin("across"));
}
}
function* inputs__lagging_inputs(lagging, conditions = []) {
let by_law, group, key, least, most, name, scaled, tested;

(group = $add(("" + "Lagging " + $str(lagging.name)), ($truth(conditions) ? ("" + ", " + $str(lagging.condition)) : "")));
(by_law = lagging.source_of("law"));
yield new Input(group, "Friction law", $bound(lagging.law, "title"), undefined, "mu(x, p)", by_law);
if (($in("condition", lagging.sources))) {
(scaled = $at(lagging.notes, $neg(1)));
yield new Input(group, "Scaled to the condition", scaled, undefined, undefined, $at(lagging.sources, "condition"));
}
yield new Input(group, "Slip of the law includes", inputs__in_slip($bound(lagging.law, "slip_includes")), undefined, undefined, by_law);
yield* $iter(inputs___factors(group, lagging));
for ([name, key] of $iter([["lagging_thickness", "thickness"], ["shear_modulus", "shear_modulus"], ["compression_modulus", "compression_modulus"], ["wear_coefficient", "wear_coefficient"]])) {
yield inputs___named(group, name, $b.getattr(lagging, key), lagging.source_of(key));
}
(tested = lagging.law.tested);
if ((tested != null)) {
([least, most] = [tested.pressure_min, tested.pressure_max]);
yield new Input(group, "Tested from a pressure of", least, "pressure", "p", by_law);
yield new Input(group, "Tested to a pressure of", most, "pressure", "p", by_law);
yield new Input(group, "Tested to a slip of", $bound(tested, "slip_max"), "length", "x", by_law);
yield new Input(group, "Tested at a slip speed of", $bound(tested, "slip_speed"), "speed", "", by_law);
}
}
function inputs__in_slip(parts) {

if ((parts == null)) {
return "shear is not stated";
}
return $m.join(" and ", ["sliding", ...$iter(parts)]);
}
function* inputs___factors(group, lagging) {
let name, of, told;

(of = lagging.factors);
if ((of == null)) {
return null;
}
if ((of.by_slip_speed != null)) {
(name = "Friction factor of slip speed, up to");
(told = ("" + "the least is " + $format(of.of_slip_speed, ("" + ".3g"))));
yield new Input(group, name, $bound(of, "fastest"), "speed", "", $bound(of.by_slip_speed, "source"), told);
}
if ((of.by_temperature != null)) {
(told = ("" + $format(of.of_temperature, ("" + ".3g"))));
if ((of.temperature == null)) {
(told = ("" + $str(told) + ", the least of its table: no temperature is given"));
}
(name = "Friction factor of temperature");
yield new Input(group, name, told, undefined, undefined, of.by_temperature.source);
}
}
function* inputs___tensions(drive, arc) {
let group, name, origin, pulley, share, tight, used, value, why;
(pulley = $b.next((function* () { for (const p of $iter(drive.pulleys)) { if (!(($eq(p.name, arc.pulley)))) continue; yield p; } })()));
(group = inputs___arc_group(drive, arc));
(tight = ((arc.entry_tension >= arc.exit_tension) ? "entry_tension" : "exit_tension"));
for (name of $iter(["entry_tension", "exit_tension"])) {
([value, used] = [$b.getattr(arc, name), ""]);
if ((($eq(name, tight)) && (drive.belt.rating != null))) {
(share = cell__percent((value / $mul(drive.belt.rating, drive.belt.width))));
(used = ("" + $str(share) + " of the belt's rating"));
}
(origin = $m.get(pulley.sources, name, $c81));
(why = inputs___computed(drive, arc, $m.removesuffix(name, "_tension")));
if ($truth(why)) {
([used, origin] = [$m.join("; ", $b.filter(null, [("" + $str($at($c83, name)) + " " + $str(why)), used])), null]);
}
yield inputs___named(group, name, value, origin, used);
}
}
function inputs___arc_group(drive, arc) {
let several;
(several = ($b.len($bound(drive, "pulleys")) > 1));
return $add(("" + "Load case " + $str(arc.load_case)), ($truth(several) ? ("" + ", pulley " + $str(arc.pulley)) : ""));
}
function inputs___computed(drive, arc, side) {
let cases, found;

(cases = ($truth($b.isinstance(drive, Drive)) ? drive.load_cases : []));
(found = (function* () { for (const c of $iter(cases)) { if (!(($eq(c.name, arc.load_case)))) continue; yield $at(c.tensions, arc.pulley).computed; } })());
return $m.get($b.next(found, $map([])), side, "");
}
function input_tables__input_rows(inputs, of) {

return $b.tuple((function* () { for (const entry of $iter(inputs)) { if (!((entry.value != null))) continue; yield new Row($bound(entry, "title"), [entry.text()], $bound(entry, "symbol"), entry.note(of), $bound(entry, "name")); } })());
}
function errors___stopped(sentence) {
return ((!$truth(sentence) || ($in($at(sentence, $neg(1)), ".?!"))) ? sentence : $add(sentence, "."));
}
function problems___renamed(key, names) {
let name, path, place, position;

(place = []);
(path = []);
for ([name, position] of $iter($m.findall($c84, key))) {
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
(sources = origins__read_sources(record, $c85, report));
(common = $map([...(function* () { for (const key of $iter($c86)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
$put(common, "provenance", $or(origins__own_provenance(record, report), () => new Provenance()));
$put(common, "cost", $c87.built($m.get(record, "cost"), report));
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

(given = [...(function* () { for (const key of $iter($c88)) { if (!(($in(key, record)))) continue; yield key; } })()]);
if (!$truth(record.sound("thickness", ...$iter($c88)))) {
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
(stated = $map([...(function* () { for (const key of $iter($c89)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
return ($truth(known) ? $merged(lagging_build___estimated(record, sources, provenance, report), stated) : stated);
}
function lagging_build___estimated(record, sources, provenance, report) {
let basis, block, height, least, message, moduli, remedy, shape, text, young;

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
(least = $at($c90, "height").least);
if (($truth(height) && $truth(shape) && ($at(record, "thickness") < least))) {
(message = ("" + "must be at least " + $str(display__display(least, "length")) + ", the height of its blocks"));
(remedy = "Give the thickness, or a lagging without blocks.");
report.add([...$iter(record.place), "thickness"], message, remedy, $m.get(record.raw, "thickness"));
return $map([]);
}
(block = $method($c91, "built", [shape, report], [...height]));
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
$put(found, $at(row, "condition"), $method($c92, "built", [row, report], [["source", source]]));
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
return $map([["law", ((factors != null) ? factors.used : tested)], ["factors", factors], ["condition", $m.get(law, "condition", "dry")], ["fit", $c99.built($m.get(law, "fit"), report)], ["notes", [...$iter(notes), ...$iter($m.get(law, "notes", []))]], ["sources", $merged(sources, $map([...(function* () { for (const [part, of] of $iter($m.items(parts))) { if (!($truth(of))) continue; yield [part, of]; } })()]))]]);
}
function laws__read_law(record, report) {
let error, kind, law, names;

if (!$truth(record.sound())) {
return null;
}
(kind = $at(record, "kind"));
(names = $merged($c93, $map([["pressure", $m.get($c94, kind, "tested_pressure")]])));
try {

if (($eq(kind, "integral-log"))) {
(law = laws___integral_log(record));
} else {
if (($eq(kind, "table"))) {
(law = laws___table(record));
} else {
(law = $method($c95, "built", [record, report], [["tested", laws___tested(record)]]));
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
return errors__input_error(message, remedy, undefined, key, value);
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

return $c96;
}
const $kept_trends___grammar = new Map();
function trends___refused(text, message) {
return errors__input_error(message, "Write it over the pressure p as a polynomial (0.12 - 0.00021 p + 1.4e-7 p^2), a logarithm (-0.31 + 0.042 ln(p)), a power (-1.6 p^-0.45) or an exponential (-0.2 exp(-0.0031 p)).", undefined, undefined, $shown(text));
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
for ([key, table] of $iter([["slip_speed", $c97], ["temperature", $c98]])) {
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
throw errors__input_error("is not the name of its file", ("" + "Write name = " + $str($shown(name)) + ", or rename the file."), ("" + "catalogue lagging " + $str(name)), "name", $shown($at(record, "name")));
}
return record;
}
const $kept_lagging_file___catalogue_record = new Map();
function lagging_file___record(text, file) {
return lagging_file___checked_record(parsed(text, file), file);
}
function lagging_file___checked_record(document, file) {
let record, report;

([record, report] = source__read_tables($c100, document, file));
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
throw errors__input_error("the path of a file cannot be used here", ("" + "Choose one of " + $str($m.join(", ", laggingNames())) + ", or put the lagging into the drive file as a [lagging.NAME] table."), undefined, undefined, $shown(name_or_path));
}
(path = readText(folder, name_or_path));
return [lagging_file___record(readText(path), path), path];
}
function drive_build___merged_origins(base, given) {
let own, provenance, sources;

(own = $or($m.get(given, "provenance"), () => drive_build___given_instead(given)));
(sources = $map([...(function* () { for (const [key, of] of $iter($m.items($m.get(base, "sources", $map([]))))) { if (!((!$in(key, given)))) continue; yield [key, of]; } })()]));
(sources = $merged(sources, $map([...(function* () { for (const key of $iter(given)) { if (!(($in(key, $c102)))) continue; yield [key, own]; } })()])));
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

(there = [...(function* () { for (const d of $iter((() => $c72)())) { if (!((($eq(d.standard, standard)) && ($eq(d.surface, surface))))) continue; yield d; } })()]);
(here = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, condition)))) continue; yield d; } })(), null));
(dry = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, tested)))) continue; yield d; } })(), null));
if (((here == null) || (dry == null))) {
(known = $b.sorted(new Set((function* () { for (const d of $iter((() => $c72)())) { if (!($truth(d.condition))) continue; yield d.standard; } })())));
throw errors__input_error(("" + "no design values of surface " + $str($shown(surface)) + " both " + $str(tested) + " and " + $str(condition)), ("" + $str($m.join(", ", known)) + " have dry, wet, and wet and dirty; or state a factor."), undefined, ("" + "condition." + $str(condition)), $shown(standard));
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

(values = (function* () { for (const d of $iter((() => $c72)())) { if (!((($eq(d.surface, surface)) && $truth(d.condition)))) continue; yield d; } })());
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
return errors__input_error(("" + $str(of) + " has no such " + $str(what)), $m.strip(("" + $str(errors__nearest(name, names)) + " " + $str(there))), undefined, undefined, $shown(name));
}
function drive___pull(case_) {
return $math.fsum((function* () { for (const t of $iter($m.values(case_.tensions))) { yield t.effective; } })());
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
function drive___alike(tensions) {
return ($sub($b.max(tensions), $b.min(tensions)) <= $mul(1e-06, $b.max(tensions)));
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
function check___badness(check) {
let order, unknown;

(order = numbers__order_of($bound(check, "margin"), $bound(check, "missed"), $bound(check, "binding"), $bound(check, "advises"), $bound(check, "leads")));
(unknown = (check.level === "NOT CHECKED"));
return [$neg(($truth(unknown) ? $add($told($c110, "OK", "rank"), 0.5) : $told($c110, check.level, "rank"))), order];
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
function simple___is_friction(mu) {
let message;

(message = ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " and finite"));
return [(1e-06 <= mu && mu < Infinity), "friction_coefficient", ("" + $format(mu, ("" + "g"))), message];
}
function base__check(...tests) {
let failed;

(failed = [...(function* () { for (const [passed, key, value, message] of $iter(tests)) { if (!(!$truth(passed))) continue; yield new Problem(message, undefined, undefined, key, value); } })()]);
if ($truth(failed)) {
throw new InputError(failed);
}
}
function simple___edges(tested) {
return ((tested == null) ? [] : [tested.pressure_min, tested.pressure_max]);
}
function of_train___motor_torque(state) {
return state.motor;
}
function of_arc___binds(drive) {
return drive.criteria.standard.binding;
}
function of_arc___creep_limit(_, state) {
return state.creep_limit;
}
function of_arc___creeps(of) {
let limit;

(limit = of.state.creep_limit);
return new Words("Creep at exit", (($eq(limit, 0.00635)) ? "conservative limit, 1/4 in; B. DeVries, A model of lagging friction" : "given"), "over creep limit", "Creeps {value}, more than the limit of {limit}.", "A belt that creeps more than {slides} slides.", of_arc___qualifies($bound(of, "drive"), limit), "Raise the slack-side tension, enlarge the wrap angle, or choose a lagging with more friction.", "No slack-side tension is enough: enlarge the wrap angle, or choose a lagging with more friction.", $map([["fabric", [$at($c593, "fabric"), "force_per_width"]], ["slides", [0.0635, "length"]], ["allowed", [0.0127, "length"]]]));
}
function of_arc___qualifies(drive, limit) {
let belt, least, over, rating, steel, strong;

(belt = drive.belt);
if ((!$eq(limit, 0.00635))) {
return "";
}
(least = $m.get($c593, $bound(belt, "kind")));
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
function of_drive___tight(state) {
return state.tight;
}
function of_drive___running_tension(of) {
return (($eq(of.case.kind, "running")) ? of_drive__allowed_tension($bound(of.drive, "belt"), $bound(of.case, "kind")) : null);
}
function of_drive__allowed_tension(belt, kind) {

return ((belt.rating == null) ? null : $mul(of_drive__tension_factor(belt, kind), belt.rating));
}
function of_drive__tension_factor(belt, kind) {

return (($eq(kind, "running")) ? 1.0 : $or(belt.momentary_factor, () => 1.0));
}
function of_drive___over_width(allowed, state) {
return $mul(allowed, state.width);
}
function of_drive___running(of) {
return (($eq(of.case.kind, "running")) ? of_drive___of_tension(of, "Belt tension, running") : null);
}
function of_drive___of_tension(of, title) {
let belt, factor, momentary, otherwise, remedy, said;
([belt, momentary] = [of.drive.belt, (!$eq(of.case.kind, "running"))]);
if ((belt.rating == null)) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "the rating of the belt is not given");
}
(factor = of_drive__tension_factor(belt, $bound(of.case, "kind")));
(said = ((!$eq(factor, 1.0)) ? ("" + "its rating times " + $format(factor, ("" + "g"))) : "its rating"));
(remedy = "Lower the slack-side tension as far as the other checks allow, or take a wider or ");
([remedy, otherwise] = [("" + $str(remedy) + "stronger belt."), "Take a wider or stronger belt."]);
if (($truth(momentary) && (belt.momentary_factor == null))) {
(remedy = "Give the momentary factor of the belt if the maker allows more while starting and braking; else take a stronger belt.");
(otherwise = "");
}
return new Words(title, ("" + "rating of the belt" + $str(((!$eq(factor, 1.0)) ? ("" + " times " + $format(factor, ("" + "g"))) : "")) + ": " + $str(rule__origin($m.get(belt.sources, "rating", $bound(belt, "provenance"))))), "over belt rating", ("" + "The belt tension {value} is more than " + $str(said) + " allows, {limit}; it is {share} % of the rating."), undefined, undefined, remedy, otherwise, $map([["share", [($mul(100.0, of.state.tight) / $mul(belt.rating, belt.width)), "number"]]]));
}
function rule__origin(provenance) {

return $b.str(provenance);
}
function of_drive___momentary_tension(of) {
return ((!$eq(of.case.kind, "running")) ? of_drive__allowed_tension($bound(of.drive, "belt"), $bound(of.case, "kind")) : null);
}
function of_drive___momentary(of) {
return ((!$eq(of.case.kind, "running")) ? of_drive___of_tension(of, "Belt tension, momentary") : null);
}
function of_drive___rated(drive) {
return of_drive__rated($bound(drive, "belt"));
}
function of_drive__rated(belt) {
let rating, strength;

([strength, rating] = [belt.breaking_strength, belt.rating]);
return $and((strength != null), () => $and((rating != null), () => (strength >= $mul(4.0, rating))));
}
function of_drive___belt_safety(state) {
return ($mul(state.strength, state.width) / state.tight);
}
function of_drive___asked_safety(of) {
return of_drive__asked_safety($bound(of.drive, "belt"), $bound(of.case, "kind"));
}
function of_drive__asked_safety(belt, kind) {
let asked, rating, strength;

([strength, rating] = [belt.breaking_strength, belt.rating]);
if ((strength == null)) {
return NaN;
}
(asked = $m.get($c594, $bound(belt, "kind"), ((rating == null) ? NaN : 4.0)));
if (((rating != null) && $truth(of_drive__rated(belt)))) {
(asked = (strength / rating));
}
(asked = (asked / of_drive__tension_factor(belt, kind)));
return $b.max(asked, 1.0);
}
function of_drive___safety(of) {
let belt, factor, momentary, source, title, why;

([belt, momentary, factor] = [of.drive.belt, (!$eq(of.case.kind, "running")), ""]);
(title = ("" + "Safety factor of the belt, " + $str(($truth(momentary) ? "momentary" : "running"))));
if ((belt.breaking_strength == null)) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "the strength of the belt is not given");
}
if ($truth($math.isnan(of_drive__asked_safety(belt, $bound(of.case, "kind"))))) {
(why = "neither rating nor kind of the belt tells what it is to be");
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, why);
}
if (($truth(momentary) && (belt.momentary_factor != null))) {
(factor = ("" + " over momentary_factor, " + $format(belt.momentary_factor, ("" + "g"))));
}
(source = ("" + "customary for " + $str(belt.kind) + ", by works that follow DIN 22101" + $str(factor)));
if ((!$in(belt.kind, $c594))) {
(source = ("" + "the least that any belt is rated with" + $str(factor)));
}
if ($truth(of_drive__rated(belt))) {
(source = ("" + "strength over rating of the belt" + $str(factor) + ": " + $str(rule__origin(belt.source_of("rating")))));
}
return new Words(title, source, "belt safety factor", "The strength of the belt is {value} times its tension, below {limit} times.", "No belt is rated at more than a third of its strength.", undefined, "Lower the slack-side tension as far as the other checks allow, or take a wider or stronger belt.", "Take a wider or stronger belt.");
}
function of_drive___tight_pressure(state) {
return of_drive__wrap_pressure($bound(state, "tight"), state);
}
function of_drive__wrap_pressure(tension, state) {

return ($mul(2.0, $sub(tension, state.centrifugal)) / $mul(state.width, state.diameter));
}
function of_drive___face_pressure(of) {
return of.drive.belt.largest_wrap_pressure;
}
function of_drive___on_face(of) {
let belt, title;
([belt, title] = [of.drive.belt, "Pressure on the pulley face"]);
if ((belt.largest_wrap_pressure == null)) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "the largest wrap pressure of the belt is not given");
}
return new Words(title, rule__origin($m.get(belt.sources, "largest_wrap_pressure", $bound(belt, "provenance"))), "face pressure", "The belt presses on the pulley face with {value}, more than {limit}.", undefined, undefined, "Take a larger or wider pulley, or less tension.", "Take a larger or wider pulley.");
}
function of_arc___bond_strength(of) {
return of.pulley.lagging.bond_strength;
}
function of_arc___bond(of) {
let says, title;
(title = "Shear stress of lagging and bond, steady");
if ($truth(of.place.event)) {
(title = "Largest shear stress of lagging and bond");
}
(says = "The shear stress of lagging and bond, {value}, is above their {limit}.");
return of_arc___of_stress(of, "bond_strength", title, "bond overstressed", says);
}
function of_arc___of_stress(of, key, title, short, says) {
let lagging, why;
(lagging = of.pulley.lagging);
if (($b.getattr(lagging, key) == null)) {
(why = ("" + "the " + $str($m.replace(key, "_", " ")) + " of lagging " + $str(lagging.name) + " is not given"));
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, why);
}
return new Words(title, rule__origin(lagging.source_of(key)), short, says, undefined, undefined, "Choose a lagging with a stronger bond, a larger pulley, or less pull.");
}
function of_arc___fatigue_limit(of) {
return of.pulley.lagging.fatigue_limit;
}
function of_arc___tires(of) {
let found, more, often, pitch, says, speed, title;
([often, speed, more] = ["", of.drive.belt.speed, $b.dict()]);
if (((speed != null) && (of.result != null))) {
(often = "; the belt passes {passes} times an hour");
(pitch = $add(of.result.arc.radius, of.result.arc.offset));
$put(more, "passes", [pitch__turns_an_hour(speed, pitch), "number"]);
}
(title = "Shear stress of lagging and bond, at every pass");
(says = "At every pass the shear stress reaches {value}, above the fatigue limit {limit}");
(found = of_arc___of_stress(of, "fatigue_limit", title, "lagging tires", ("" + $str(says) + $str(often) + ".")));
return $replaced(found, new Map([["more", more]]));
}
function of_drive___pressure_max(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.pressure_max);
}
function of_drive___tested_max(of) {
let otherwise, why;
if ((of.pulley.lagging.law.tested == null)) {
(why = "the friction law states no tests");
return new Words("Wrap pressure within the tests", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, why);
}
(otherwise = "Take a larger or wider pulley, or test the lagging at this pressure.");
return of_drive___of_pressure(of, "Largest", "above", "Lower the tension, t", otherwise);
}
function of_drive___of_pressure(of, end, beyond, tension, otherwise) {
return new Words(("" + $str(end) + " wrap pressure, tested"), of_drive__tests_of($bound(of, "pulley")), ("" + "pressure " + $str(beyond) + " tests"), ("" + "The wrap pressure {value} is " + $str(beyond) + " the {limit} tested on lagging " + $str(check__escaped($bound(of.pulley.lagging, "name"))) + ": there the friction is an extrapolation."), undefined, undefined, ("" + $str(tension) + $str($slice(otherwise, 1, null))), otherwise);
}
function of_drive__tests_of(pulley) {

return ("" + "tests of lagging " + $str(pulley.lagging.name) + ": " + $str(rule__origin(pulley.lagging.source_of("law"))));
}
function of_drive___slack_pressure(state) {
return of_drive__wrap_pressure($bound(state, "slack"), state);
}
function of_drive___pressure_min(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.pressure_min);
}
function of_drive___tested_min(of) {
let otherwise;
if ((of.pulley.lagging.law.tested == null)) {
return null;
}
(otherwise = "Test the lagging at this pressure.");
return of_drive___of_pressure(of, "Least", "below", "Raise the slack-side tension, or t", otherwise);
}
function of_arc___slip_max(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.slip_max);
}
function of_arc___slips(of) {
if ((of.pulley.lagging.law.tested == null)) {
return null;
}
return new Words("Largest slip, tested", of_drive__tests_of($bound(of, "pulley")), "slip beyond tests", ("" + "The slip {value} is beyond the {limit} that lagging " + $str(check__escaped($bound(of.pulley.lagging, "name"))) + " was tested to: there the friction is an extrapolation."), undefined, undefined, "Raise the slack-side tension, or test the lagging to this slip.", "Test the lagging to this slip.");
}
function of_arc___tested_speed(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.slip_speed);
}
function of_arc___slips_fast(of) {
let tested, title, why;
([tested, title] = [of.pulley.lagging.law.tested, "Slip speed, tested"]);
if ((tested == null)) {
return null;
}
if ((tested.slip_speed == null)) {
(why = "the friction law does not say at which speed it was tested");
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, why, true);
}
if (((of.drive.belt.speed == null) || $truth($math.isnan($m.get(of.state.found, "slip_speed", 0.0))))) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "the belt speed is not given");
}
return new Words(title, of_drive__tests_of($bound(of, "pulley")), "slips faster than tests", ("" + "The belt slips at up to {value}, lagging " + $str(check__escaped($bound(of.pulley.lagging, "name"))) + " was tested at {limit}: how its friction changes with speed is not known."), undefined, undefined, "Test the lagging at this speed, or keep a larger safety factor.");
}
function of_drive___slack_end(state) {
return state.slack_end;
}
function of_drive___sag_tension(of) {
return ((of.drive.criteria.sag == null) ? null : of.drive.criteria.sag.tension);
}
function of_drive___sags(of) {
let limits, title;

([title, limits] = ["Slack-side tension, for sag", of.drive.criteria.sag]);
if ($truth($math.isnan($bound(of.state, "slack_end")))) {
return null;
}
if ((limits == null)) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "idler spacing and mass are not given");
}
return new Words(title, limits.SOURCE, "sags", ("" + "The slack side, {value}, sags more than " + $format($mul(100.0, limits.share), ("" + "g")) + " % of the idler spacing; that takes {limit}."), undefined, undefined, "Raise the slack-side tension, or set the idlers closer.", "Set the idlers closer.");
}
function of_drive___diameter(state) {
return state.diameter;
}
function of_drive___least_diameter(of) {
return of.drive.belt.least_pulley_diameter;
}
function of_drive___bends(of) {
let belt, ends, pulley, title, why;

([belt, title, pulley] = [of.drive.belt, "Pulley diameter, least for the belt", of.pulley]);
(ends = [...(function* () { for (const case_ of $iter(of.drive.load_cases)) { yield $at(case_.tensions, pulley.name); } })()]);
if ((belt.least_pulley_diameter == null)) {
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "the least pulley of the belt is not given");
}
if ($truth($b.all((function* () { for (const at of $iter(ends)) { yield numbers__idles($bound(at, "entry"), $bound(at, "exit")); } })()))) {
(why = "that of the belt is the least drive pulley, and this one pulls nothing");
return new Words(title, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, why);
}
return new Words(title, rule__origin($m.get(belt.sources, "least_pulley_diameter", $bound(belt, "provenance"))), "pulley too small", ("" + "Pulley " + $str(check__escaped($bound(pulley, "name"))) + ", {value}, is smaller than the least for its belt, {limit}."));
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
function tables__need(key, meaning = "", kind = $c866, more = new Map()) {

return $replaced($call(Entry, [key, meaning, kind], [...more]), new Map([["required", true]]));
}
function resistance__no_coefficient(length) {
let least;

if (!$truth($math.isnan(resistance__coefficient_at(length)))) {
return [];
}
(least = $at($at($c871, 0), 0));
return [new Problem(("" + "is below " + $format(least, ("" + "g")) + " m, where no coefficient C is tabulated"), "Give secondary_resistance, or a length_coefficient of your own.", undefined, "length", display__display(length, "length"))];
}
function resistance__coefficient_at(length) {
let end, found, high, low, start;

(found = ((length < $at($at($c871, 0), 0)) ? NaN : $at($at($c871, $neg(1)), 1)));
for ([[start, high], [end, low]] of $iter($b.pairwise($c871))) {
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
function check__keeps(value, limit, at_most = true) {

return numbers__kept(value, limit, at_most);
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
function* of_arc___standard(of) {
let _, chosen, criteria, found, how, limit, name, pulley, rule, start, tensions, title, words;

([criteria, pulley] = [of.drive.criteria, of.pulley]);
(found = design_standard__asked($bound(criteria, "standard"), $bound(criteria, "take_up"), $bound(pulley, "lagging"), $bound(pulley, "wrap_angle")));
([tensions, rule] = [$at(of.case.tensions, pulley.name), $c575.held($bound(of, "drive"))]);
if (((found == null) || $truth(numbers__idles($bound(tensions, "entry"), $bound(tensions, "exit"))))) {
return null;
}
if ($truth($math.isnan($bound(found, "wrap_factor")))) {
(title = ("" + "Slack side by " + $str(found.rule)));
if (!$truth(criteria.standard.name)) {
yield rule__not_checked($bound(rule, "name"), title, $bound(found, "why_not"), $bound(of, "place"));
return null;
}
yield new Check(rule.name, title, rule.missed, of.place, undefined, undefined, undefined, undefined, undefined, "standard not applicable", check__escaped(("" + $str(found.rule) + " was chosen and cannot be applied: " + $str(found.why_not) + ".")), "Give what it asks for, or choose another design standard.", undefined, undefined, rule.binding);
return null;
}
(chosen = ($truth(criteria.standard.name) ? "" : " No standard was chosen: CEMA was taken."));
([start, [name, _, how]] = ["", $m.partition(found.rule, ", ")]);
if (((!$eq(criteria.standard.start_factor, 1.0)) && ($eq(of.case.kind, "running")))) {
(start = ("" + " at " + $format(criteria.standard.start_factor, ("" + "g")) + " times the pull"));
}
(limit = of_arc__design_slack(of, $bound(found, "wrap_factor")));
(words = new Words(("" + "Slack side by " + $str(found.rule)), found.source, "below standard", ("" + "Slack side {value} is below the {limit} of " + $str(name) + "; " + $str(how) + $str(start) + "." + $str(chosen)), undefined, undefined, "Raise the slack-side tension, or choose the design standard.", "Choose the design standard."));
yield rule.judged($bound(of.state, "slack"), limit, $bound(of, "place"), words);
}
function* of_arc___cover_creep(of) {
let found, rule, title, told, words;

([rule, title] = [$c577, "Creep at exit, with the cover of the belt in series"]);
if (((of.result == null) || ($eq(of.result.arc.cover_left_out, 0.0)))) {
return null;
}
if ($truth(of.unknown)) {
yield rule__not_checked($bound(rule, "name"), title, $bound(of, "unknown"), $bound(of, "place"));
return null;
}
(found = of.result.covered_creep);
(told = ($truth($math.isfinite(found)) ? "the creep is {value}" : "the belt slips through"));
(words = new Words(title, "shear of the cover of the belt", "limit within belt cover", ("" + $str("Whether the tested slip includes the shear of the belt cover is not known") + ": with the cover in series " + $str(told) + ", beyond the limit of {limit}."), undefined, undefined, "State the cover of the test belt with the shear tests, or raise the slack-side tension.", "State the cover of the test belt with the shear tests."));
yield rule.judged($b.abs(found), $bound(of.state, "creep_limit"), $bound(of, "place"), words);
}
function* in_page_checks__creep_interval(of) {
let fit;

(fit = ((of.result == null) ? null : of.result.arc.fit));
if (((fit == null) || !$truth(fit.knots))) {
return null;
}
yield new Check("creep_interval", "Creep at exit, end of the 95 % interval of the law", "ATTENTION", of.place, undefined, undefined, undefined, undefined, undefined, "interval not found here", "By the uncertainty of the friction law the creep may be beyond its limit: this page does not find the interval.", "Solve the file with wraparc solve, which does.", undefined, undefined, false);
}
function of_drive___rounded_safety(safety, asked, state) {
let allowed;

(allowed = ($mul(state.strength, state.width) / asked));
return (((safety < asked) && $truth(numbers__same_shown($bound(state, "tight"), allowed))) ? asked : safety);
}
function* of_data___condition(of) {
let _, grounds, lagging, law, says;

(lagging = of.pulley.lagging);
if (($in("condition", lagging.sources))) {
([grounds, _] = of_data__law_words(lagging));
(law = (($in("untested", grounds)) ? "one without tests" : "a tested one"));
(law = (($in("illustrative", grounds)) ? "an illustrative one" : law));
(says = ("" + "its law is " + $str(law) + " scaled as a whole (" + $str($at(lagging.notes, $neg(1))) + ")"));
yield of_data___untested(of, $bound(lagging, "condition"), "condition", says);
}
if (($in("worn", lagging.sources))) {
(says = "its law is that of before, and what wear takes off the friction is not known");
yield of_data___untested(of, "worn", "worn", says);
}
}
function of_data___untested(of, state, part, says) {
let lagging;
(lagging = of.pulley.lagging);
return new Check("condition", ("" + "Friction of " + $str(lagging.name) + ", " + $str(state)), "ATTENTION", of.place, undefined, undefined, undefined, undefined, rule__origin($at(lagging.sources, part)), ("" + "not tested " + $str(state)), check__escaped(("" + "Lagging " + $str(lagging.name) + " was not tested " + $str(state) + ": " + $str(says) + ".")), ("" + "Test the lagging " + $str(check__escaped(state)) + "."), undefined, undefined, false);
}
function* of_data___fit(of) {
let first, lagging, more, others;

(lagging = of.pulley.lagging);
if (((lagging.fit == null) || !$truth(lagging.fit.misfit))) {
return null;
}
([first, ...more] = lagging.fit.misfit);
(others = ($truth(more) ? ("" + " (and " + $str($b.len(more)) + " more of its lagging file)") : ""));
yield new Check("fit", ("" + "Friction of " + $str(lagging.name) + ", fit to its tests"), "ATTENTION", of.place, undefined, undefined, undefined, undefined, rule__origin($m.get(lagging.sources, "law", $bound(lagging, "provenance"))), "does not fit its tests", check__escaped(("" + "The friction law of lagging " + $str(lagging.name) + " does not describe its tests: " + $str($m.rstrip(first, ".")) + $str(others) + "." + $str(of_data___accepted($bound(lagging.fit, "misfit_accepted"))))), "Mend or repeat those tests and fit again.", undefined, undefined, false);
}
function of_data___accepted(reason) {
return ($truth(reason) ? ("" + " The laboratory wrote it nevertheless: " + $str($m.rstrip(reason, ".")) + ".") : "");
}
function* of_arc___balance(of) {
let arc, error, g, pull, result, value, words;

(result = of.result);
if (((result == null) || $truth(of.unknown) || $truth($math.isnan($bound(result.energy, "identity_error"))))) {
return null;
}
([error, arc] = [result.energy.identity_error, result.arc]);
([pull, g] = [result.effective_tension, result.entry_creep_ratio]);
(value = numbers__balance_miss(error, pull, g, $bound(arc, "entry_tension"), $bound(arc, "compliance")));
(words = new Words("Energy balance of the solution", "tolerance of the program", "out of balance", "The energy balance of the solution misses by {value}, more than {limit}.", undefined, undefined, "Please report the drive file; until then change a value slightly."));
yield $c591.judged(value, 0.0001, $bound(of, "place"), words);
}
function numbers__balance_miss(error, pull, g, entry, compliance) {
let exact, scale, told;

(exact = $b.abs($mul(pull, $add(g, $mul($mul(0.5, pull), compliance)))));
(told = $b.max(exact, $mul($mul(1e-06, entry), $b.abs(g)), 1e-300));
(scale = $b.max(exact, $mul($mul(1e-06, entry), $add($b.abs(g), $mul(entry, compliance)))));
return ((scale > 0.0) ? ($mul($b.abs(error), told) / scale) : 0.0);
}
function numbers__beyond(value, fails, at_most) {

return ($truth(at_most) ? (value > fails) : (value < fails));
}
function kinds__table_labels(rows) {
let names;

(names = [...(function* () { for (const row of $iter(rows)) { yield ($truth($b.isinstance(row, "dict")) ? $m.get(row, "name") : null); } })()]);
return [...(function* () { for (const [position, name] of $iter($b.enumerate(names, $k({start: 1})))) { yield (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($eq($m.count(names, name), 1))) ? name : position); } })()];
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
$sig(Problem, ["message", "remedy", "file", "key", "value", "line", "code"], false, {remedy: () => "", file: () => "", key: () => "", value: () => "", line: () => null, code: () => ""});
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
add(place, message, remedy = "", value = $c7, code = "") {
const self = this; let given, key;

if ($truth(self.full)) {
(self._left_out = $add(self._left_out, 1));
return null;
}
(given = ((value === $c7) ? "" : $shown(value)));
(code = (($eq(message, "missing")) ? "missing" : code));
(key = problems__place_text(place));
self._append(new Problem(message, remedy, undefined, key, given, undefined, code));
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
__post_init__() {
const self = this; if (((self.kind === "published") && !$truth($m.strip(self.source)))) {
throw errors__input_error("a published number without a source", "Name the publication, or call the number given or illustrative.");
}
}
__str__() {
const self = this; let origin, stated;
(origin = $m.join(", ", (function* () { for (const part of $iter([self.source, self.date])) { if (!($truth(part))) continue; yield part; } })()));
(stated = ($truth(origin) ? ("" + $str(self.kind) + ": " + $str(origin)) : $b.str($bound(self, "kind"))));
return ($truth(self.note) ? ("" + $str(stated) + " (" + $str(self.note) + ")") : stated);
}
}
$sig(Provenance, ["kind", "source", "date", "note"], false, {kind: () => "given", source: () => "", date: () => "", note: () => ""});
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
for (group of $iter($c101)) {
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

(tables = $b.fromkeys((function* () { for (const d of $iter((() => $c72)())) { if (!($truth(d.condition))) continue; yield d.standard; } })()));
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
$sig(Condition, ["name", "factor", "factors", "standard", "source"], false, {factor: () => null, factors: () => new Map(), standard: () => "", source: () => new Provenance()});
class Conditions extends $Object {
get several() {
const self = this; 
return [...$iter((($b.len($bound(self, "main")) > 1) ? self.main : [])), ...$iter(self.cases)];
}
}
$sig(Conditions, ["main", "cases"], false, {main: () => [], cases: () => []});
class Point extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get side() {
const self = this; 
return $mul((self.diameter / 2.0), (($eq(self.turn, "counterclockwise")) ? 1.0 : $neg(1.0)));
}
}
$sig(Point, ["x", "y", "diameter", "turn"], false, {diameter: () => 0.0, turn: () => "clockwise"});
class _UnitTextError extends $Error {
$init(message, remedy) {
const self = this; super.$init(message);
(self.remedy = remedy);
}
}
class Unit extends $Tuple {
}
$sig(Unit, ["factor", "powers", "zero"], false, {zero: () => $c111});
class UnitRow extends $Tuple {
}
$sig(UnitRow, ["unit", "factor", "larger"], false, {});
class WidthProfile extends $Object {
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

get largest() {
const self = this; 
return $add($b.max([...$iter(self.value), 0.0]), $b.max($bound(self, "crown"), 0.0));
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
}
$sig(WidthProfile, ["position", "value", "crown", "uncertainty"], false, {position: () => [], value: () => [], crown: () => 0.0, uncertainty: () => null});
class Criteria extends $Object {
}
$sig(Criteria, ["take_up", "standard", "safety", "sag"], false, {take_up: () => new TakeUp(), standard: () => new DesignStandard(), safety: () => new SafetyFactors(), sag: () => null});
class Layers extends $Tuple {
}
$sig(Layers, ["pulley_cover", "carry_cover", "carcass"], false, {});
class Given extends $Object {
static of(name, record, diameter) {
const cls = this; let values;

(values = new LoadGiven(...$iter((function* () { for (const key of $iter($c33)) { yield $m.get(record, key); } })())));
return new cls(name, $bound(record, "place"), values, $bound(record, "raw"), diameter);
}
at(speed) {
const self = this; 
return new DrumAt($bound(self, "diameter"), speed);
}
overridden(record, fixed = false, speed = null, runs = $c103) {
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
$sig(Given, ["name", "place", "values", "raw", "diameter", "inherited"], false, {inherited: () => []});
class NipTensions extends $Tuple {
}
$sig(NipTensions, ["entry", "exit"], false, {});
class Tensions extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
(self.exit = load_case__exit_behind($bound(self, "entry"), $bound(self, "exit")));
}
get effective() {
const self = this; 
return $sub(self.entry, self.exit);
}
get ratio() {
const self = this; 
return (self.entry / self.exit);
}
}
$sig(Tensions, ["entry", "exit", "computed"], false, {computed: () => new Map()});
class LoadCase extends $Object {
__post_init__() {
const self = this; let problems;
(problems = criteria__choice_problems(self, $map([["kind", $c104]])));
limits__raise_all($add(limits__name_problems("name", $bound(self, "name")), problems));
}
}
$sig(LoadCase, ["name", "tensions", "kind", "condition"], false, {kind: () => "running", condition: () => ""});
class Viewable extends $Object {


}
class Drive extends Viewable {
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
return load_case__heaviest($bound(self, "load_cases"), drive___pull);
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
const self = this; let entry, leaving;

([entry, leaving] = self._ends(case_));
return ((drive___pull(case_) >= 0.0) ? leaving : entry);
}
take_up_tension(case_) {
const self = this; let entry, leaving, steady, take_up;

(take_up = self.criteria.take_up);
if ((self.conveyor != null)) {
return self.conveyor.take_up;
}
if ($truth(take_up.fixed)) {
return self.slack_end(self.load_case());
}
if ($truth(take_up.after)) {
return $at(case_.tensions, take_up.after).exit;
}
([entry, leaving] = self._ends(case_));
(steady = self._steady_end);
return (($eq(steady, "")) ? self.slack_end(case_) : (($eq(steady, "exit")) ? leaving : entry));
}
get take_up_place() {
const self = this; let after, away, ends, held, steady, take_up;

(take_up = self.criteria.take_up);
(ends = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield self.slack_end(case_); } })()]);
if ((self.conveyor != null)) {
(held = self.conveyor.take_up);
(away = $b.any((function* () { for (const end of $iter(ends)) { yield ($b.abs($sub(end, held)) > $mul(1e-06, held)); } })()));
return ($truth(away) ? "at the take-up" : "");
}
if ($truth(take_up.fixed)) {
return ($truth(drive___alike(ends)) ? "" : ("" + "of the slack side in load case " + $str(self.load_case().name)));
}
(steady = self._steady_end);
if ((($eq(steady, "entry")) && !$truth(take_up.after))) {
return ("" + "at the take-up ahead of pulley " + $str($at(self.pulleys, 0).name));
}
(after = $or(take_up.after, () => (($eq(steady, "exit")) ? $at(self.pulleys, $neg(1)).name : "")));
return ($truth(after) ? ("" + "at the take-up behind pulley " + $str(after)) : "");
}
get _steady_end() {
const self = this; let drives, entries, exits, pulls, slack, steadier, tight;

(pulls = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield drive___pull(case_); } })()]);
(entries = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield $at(self._ends(case_), 0); } })()]);
(exits = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield $at(self._ends(case_), 1); } })()]);
if (($b.min(pulls) < 0.0 && 0.0 < $b.max(pulls))) {
(steadier = ($mul($b.min(exits), $b.max(entries)) >= $mul($b.min(entries), $b.max(exits))));
return ($truth(steadier) ? "exit" : "entry");
}
(drives = ($b.min(pulls) >= 0.0));
([slack, tight] = ($truth(drives) ? [exits, entries] : [entries, exits]));
if (($truth(drive___alike(slack)) || !$truth(drive___alike(tight)))) {
return "";
}
return ($truth(drives) ? "entry" : "exit");
}
_ends(case_) {
const self = this; let first, last;
([first, last] = [$at(self.pulleys, 0).name, $at(self.pulleys, $neg(1)).name]);
return [$at(case_.tensions, first).entry, $at(case_.tensions, last).exit];
}
creep_limit_of(pulley) {
const self = this; 
return ((pulley.creep_limit == null) ? self.creep_limit : pulley.creep_limit);
}
}
$sig(Drive, ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description", "conveyor"], false, {title: () => "", creep_limit: () => 0.00635, criteria: () => new Criteria(), description: () => "", conveyor: () => null});
class Train extends $Object {
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
$sig(Train, ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria"], false, {title: () => "", description: () => "", nominal_diameters: () => [], creep_limit: () => 0.00635, criteria: () => new Criteria()});
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
([runs, fixed] = [$c103, self._take_up.fixed]);
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
if (((division == null) || !$truth($b.any((function* () { for (const key of $iter([...$iter($c105), ...$iter($c106), "run"])) { yield ($in(key, over)); } })())))) {
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
if (((over != null) && $truth($b.any((function* () { for (const mode of $iter($c106)) { yield ($in(mode, over)); } })())))) {
(record = over);
}
(modes = [...(function* () { for (const mode of $iter($c106)) { if (!(($in(mode, record)))) continue; yield mode; } })()]);
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
(remedy = ("" + "Write [train.motor." + $str(name) + "] with kind = \"" + $str($b.next($b.iter($c107))) + "\"."));
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
(motor = $c108.built(record, $bound(self, "_report")));
return motor;
}
}
class CatalogueBelt extends $Object {
get sources() {
const self = this; 
return ($truth(self.carcass_source) ? $map([["carcass", self.carcass_source]]) : $map([]));
}
}
$sig(CatalogueBelt, ["name", "kind", "rating", "modulus", "least_pulley_diameter", "carcass", "carcass_mass", "cover_mass", "provenance", "carcass_source"], false, {least_pulley_diameter: () => null, carcass: () => null, carcass_mass: () => null, cover_mass: () => null, carcass_source: () => null});
class WrapArc extends $Object {
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
return $method(cls, "on", [$bound(drive, "belt"), pulley, lagging], [["entry_tension", tensions.entry], ["exit_tension", tensions.exit], ["creep_limit", drive.creep_limit_of(pulley)], ["belt_speed", drive.belt.speed], ["fit", lagging.fit], ["load_case", case_.name]]);
}
static on(belt, pulley, lagging, more = new Map()) {
const cls = this; 
return $call(cls, [], [["law", lagging.law], ...wrap_arc__of_belt(belt, $bound(pulley, "side"), $bound(lagging, "law")), ["diameter", pulley.diameter], ["wrap_angle", pulley.wrap_angle], ["width", belt.width], ["axial_stiffness", belt.axial_stiffness], ["thickness", lagging.thickness], ["shear_modulus", lagging.shear_modulus], ["compression_modulus", lagging.compression_modulus], ["overrun", pulley.overrun], ["recovery", pulley.recovery], ["wear_coefficient", lagging.wear_coefficient], ["pulley", pulley.name], ...more]);
}
get radius() {
const self = this; 
return $mul(0.5, self.diameter);
}
get length() {
const self = this; 
return $mul(self.radius, self.wrap_angle);
}
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
get duty() {
const self = this; let pull;

(pull = self.effective_tension);
return ((pull > 0.0) ? "driving" : ((pull < 0.0) ? "braking" : "idling"));
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
load() {
const self = this; let ends, tested;

(tested = self.law.tested);
(ends = [NaN, NaN, NaN]);
if ((tested != null)) {
(ends = [tested.pressure_min, tested.pressure_max, tested.slip_max]);
}
return new Load($sub(self.entry_tension, self.centrifugal), $sub(self.exit_tension, self.centrifugal), $bound(self, "creep_limit"), ...$iter(ends), self.law.steepest_fall());
}
get compliance() {
const self = this; 
return $add((1.0 / self.axial_stiffness), self.recovery_compliance);
}
get recovery_compliance() {
const self = this; 
return summary__recovery_compliance(self.described());
}
}
$sig(WrapArc, ["law", "entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "creep_limit", "belt_speed", "wear_coefficient", "pitch_offset", "cover_compliance", "cover_left_out", "side_of_belt", "belt_thickness", "centrifugal", "fit", "pulley", "load_case"], false, {thickness: () => 0.0, shear_modulus: () => Infinity, compression_modulus: () => Infinity, overrun: () => null, recovery: () => true, creep_limit: () => 0.00635, belt_speed: () => null, wear_coefficient: () => null, pitch_offset: () => null, cover_compliance: () => 0.0, cover_left_out: () => 0.0, side_of_belt: () => "pulley", belt_thickness: () => null, centrifugal: () => 0.0, fit: () => null, pulley: () => "", load_case: () => ""});
class in_page$Given extends $Tuple {
}
$sig(in_page$Given, ["entry_tension", "exit_tension", "effective_tension", "torque", "power", "diameter", "wrap_angle", "overrun", "recovery", "width", "modulus", "speed", "thickness", "shear_modulus", "compression_modulus", "wear_coefficient", "creep_limit", "steepest_fall", "pitch_offset", "cover_compliance", "mass", "slip_with_shear", "belt_speed"], false, {});
class Rise extends $Object {
}
$sig(Rise, ["tight", "slack"], false, {});
class in_page$Criteria extends $Tuple {
}
$sig(in_page$Criteria, ["safety", "tight_rise", "slack_rise", "cover", "strength", "pulley_mass", "wet"], false, {});
class ArcResult extends Viewable {
get creep_interval() { return $kept(this, "creep_interval", this.$find_creep_interval()); }
get covered_creep() { return $kept(this, "covered_creep", this.$find_covered_creep()); }
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
get k_factor() {
const self = this; let length;

(length = $mul(self.arc.radius, self.active_arc));
return summary__spring_rate($bound(self.arc, "axial_stiffness"), length, $bound(self, "exit_creep"));
}

get sticks() {
const self = this; 
return (self.stuck_arc > 1e-09);
}
get extrapolates() {
const self = this; 
return (self.outside_tested_share > 1e-09);
}
get within_creep_limit() {
const self = this; 
return $and($told($c40, self.status, "solved"), () => ($b.abs($bound(self, "exit_creep")) <= self.arc.creep_limit));
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
$sig(ArcResult, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy"], false, {});
class FoundArc extends ArcResult {
get creep_interval() {
const self = this; 
return [NaN, NaN];
}
get covered_creep() {
const self = this; 
return self.found.covered_creep;
}
}
$sig(FoundArc, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy", "found"], false, {});
class DriveResult extends Viewable {
__iter__() {
const self = this; return $b.iter($bound(self, "arcs"));
}
arc(pulley, load_case = "") {
const self = this; let found, name;

(found = $map([...(function* () { for (const result of $iter(self)) { if (!(($eq(result.arc.pulley, pulley)))) continue; yield [result.arc.load_case, result]; } })()]));
(name = $or(load_case, () => self.drive.load_case().name));
if ((!$in(name, found))) {
throw new $KeyError([pulley, load_case]);
}
return $at(found, name);
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
get within_creep_limit() {
const self = this; 
return $b.all((function* () { for (const r of $iter(self.arcs)) { yield r.within_creep_limit; } })());
}
}
$sig(DriveResult, ["drive", "arcs"], false, {});
class TrainResult extends Viewable {
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
$sig(TrainResult, ["train", "cases"], false, {});
class CaseResult extends $Object {
__iter__() {
const self = this; return $b.iter($bound(self, "members"));
}
get adrift() {
const self = this; 
return $and((self.status === "Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction."), () => !$truth(self.case.pulls_given));
}
get within_creep_limit() {
const self = this; 
return $and($told($c40, self.status, "solved"), () => $b.all((function* () { for (const m of $iter(self.members)) { yield m.arc.within_creep_limit; } })()));
}
}
$sig(CaseResult, ["case", "status", "reason", "members", "sensitivity", "belt_speed", "other_splits", "tension_error", "speed_error"], false, {other_splits: () => [], tension_error: () => 0.0, speed_error: () => 0.0});
class MemberResult extends $Object {
get name() {
const self = this; 
return self.arc.arc.pulley;
}
}
$sig(MemberResult, ["arc", "share", "speed_ratio", "contraction_term", "creep_term", "compression_term", "thickness_term", "drum_ratio", "surface_speed", "rotation_speed", "speed_trim", "drum_torque", "drum_power", "motor"], false, {motor: () => null});
class Place extends $Tuple {
__str__() {
const self = this; let parts;
(parts = ($truth(self.pulley) ? [("" + "pulley " + $str(self.pulley))] : []));
(parts = $add(parts, ($truth(self.load_case) ? [("" + "load case " + $str(self.load_case))] : [])));
(parts = $add(parts, ($truth(self.event) ? [("" + "event " + $str(self.event))] : [])));
return $m.join(", ", parts);
}
}
$sig(Place, ["pulley", "load_case", "event"], false, {pulley: () => "", load_case: () => "", event: () => ""});
class Motors extends $Object {
}
$sig(Motors, ["motors"], false, {});
class Motor extends $Object {
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
$sig(Motor, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true});
class Check extends $Object {
get margin() {
const self = this; 
return ($truth(self.below) ? 1.0 : numbers__margin_of($bound(self, "value"), $bound(self, "limit"), $bound(self, "at_most")));
}
get compares() {
const self = this; 
return $and((!$in(self.name, $c109)), () => (self.level !== "NOT CHECKED"));
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
return ($told($c110, self.level, "rank") >= $told($c110, "ATTENTION", "rank"));
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
(words = $map([...(function* () { for (const [n, [v, d]] of $iter($m.items(self.more))) { yield [n, check__quantity_text(v, d, self._beside(n))]; } })()]));
(words = $merged(words, $map([["value", value], ["limit", limit]])));
return $m.join(" ", (function* () { for (const part of $iter([self.says, self.remedy])) { if (!($truth(part))) continue; yield $m.format(part, [], $map([...words])); } })());
}
get numerical() {
const self = this; 
return ($in(self.name, $c857));
}
get advises() {
const self = this; 
return $or(($in(self.name, $c858)), () => $and(($eq(self.name, "design_standard")), () => !$truth(self.binding)));
}
get leads() {
const self = this; 
return $and((self.level === "FAILS"), () => ($in(self.name, $c859)));
}
_beside(name) {
const self = this; let dimension, others, value;

([value, dimension] = $at(self.more, name));
(others = [...(function* () { for (const [n, [v, d]] of $iter($m.items(self.more))) { if (!(((!$eq(n, name)) && ($eq(d, dimension))))) continue; yield v; } })()]);
return $b.min(others, $k({key: ((other) => $b.abs($sub(other, value))), default: NaN}));
}
}
$sig(Check, ["name", "title", "level", "place", "value", "limit", "dimension", "at_most", "source", "short", "says", "remedy", "otherwise", "more", "binding", "miss"], false, {place: () => $c58, value: () => NaN, limit: () => NaN, dimension: () => "number", at_most: () => true, source: () => "", short: () => "", says: () => "", remedy: () => "", otherwise: () => "", more: () => new Map(), binding: () => true, miss: () => null});
class Pulls extends $Object {
}
$sig(Pulls, ["effective_tensions"], false, {});
class Shares extends $Object {
}
$sig(Shares, ["fractions"], false, {});
class Words extends $Object {
}
$sig(Words, ["title", "source", "short", "says", "because", "allows", "remedy", "otherwise", "more", "missing", "told"], false, {source: () => "", short: () => "", says: () => "", because: () => "", allows: () => "", remedy: () => "", otherwise: () => "", more: () => new Map(), missing: () => "", told: () => false});
class Speeds extends $Object {
}
$sig(Speeds, ["rotation_speeds", "absolute"], false, {absolute: () => false});
class Owner extends $Tuple {
}
$sig(Owner, ["of", "kinds", "words", "place", "more"], false, {place: () => $c58, more: () => []});
class Sliding extends $Tuple {
}
$sig(Sliding, ["place", "cause"], false, {});
class At extends $Object {
}
$sig(At, ["drive", "case", "pulley"], false, {});
class Spot extends At {
}
$sig(Spot, ["drive", "case", "pulley", "place", "state", "result", "unknown"], false, {result: () => null, unknown: () => ""});
class State extends $Object {
raised(by) {
const self = this; let end, slack, tight;

([tight, slack, end] = [$add(self.tight, by), $add(self.slack, by), $add(self.slack_end, by)]);
return $replaced(self, new Map([["tight", tight], ["slack", slack], ["slack_end", end]]));
}
}
$sig(State, ["tight", "slack", "slack_end", "width", "diameter", "strength", "centrifugal", "creep_limit", "motor", "found"], false, {});
class VariableSpeed extends Motor {
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
$sig(VariableSpeed, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "setting", "droop", "torque_limit"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, setting: () => 1.0, droop: () => 0.0, torque_limit: () => Infinity});
class Sizes extends $Tuple {
}
$sig(Sizes, ["width", "modulus", "speed", "diameter", "idle_wrap", "wrap_angle", "creep_limit", "overrun", "thickness", "shear_modulus", "compression_modulus", "rating", "strength", "bond_strength", "fatigue_limit", "face_pressure", "least_diameter", "sag", "entry", "leaving", "pull", "mass"], false, {});
class Figure extends $Object {
}
$sig(Figure, ["name", "title", "tension", "place", "binding", "at_least"], false, {binding: () => true, at_least: () => true});
class Asked extends $Object {
}
$sig(Asked, ["rule", "wrap_factor", "source", "why_not"], false, {why_not: () => ""});
class LeastTension extends $Object {
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
const self = this; let none;

(none = $or((self.tension <= self.given), () => $or($math.isinf($bound(self, "tension")), () => self.elsewhere)));
return ($truth(none) ? null : self.tension);
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
$sig(LeastTension, ["figures", "given", "counterweight", "elsewhere"], false, {elsewhere: () => false});
class Verdict extends $Object {
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
within(load_case) {
const self = this; let own;

(own = $b.tuple((function* () { for (const c of $iter(self.checks)) { if (!(($in(c.place.load_case, ["", load_case])))) continue; yield c; } })()));
return (($eq($b.len(own), $b.len($bound(self, "checks")))) ? self : new Verdict(own));
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
if ((($told($c110, self.level, "rank") > $told($c110, "OK", "rank")) && $truth(self.qualifier))) {
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
return $b.next((function* () { for (const word of $iter($c860)) { if (!(($in(word, found)))) continue; yield word; } })(), "");
}
}
$sig(Verdict, ["checks", "wet", "over_wet"], false, {wet: () => -1.0, over_wet: () => false});
class Row extends $Object {
}
$sig(Row, ["title", "values", "symbol", "note", "name", "level"], false, {symbol: () => "", note: () => "", name: () => "", level: () => null});
class Table extends $Object {
}
$sig(Table, ["title", "rows", "heads", "note", "name", "short", "brief"], false, {heads: () => $c112, note: () => "", name: () => "", short: () => null, brief: () => ""});
class FrictionLaw extends $Object {
scaled(friction = 1.0, slip = 1.0) {
const self = this; 
return (($eq(friction, slip) && $eq(slip, 1.0)) ? self : self._scaled(friction, slip));
}
}
$sig(FrictionLaw, ["slip_includes"], false, {slip_includes: () => null});
class Constant extends FrictionLaw {
__post_init__() {
const self = this; let mu;
(mu = self.friction_coefficient);
base__check(simple___is_friction(mu));
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
$sig(Constant, ["slip_includes", "friction_coefficient", "tested"], false, {slip_includes: () => null, tested: () => null});
class PressurePower extends FrictionLaw {
__post_init__() {
const self = this; let mu, n, p;
([mu, p, n] = [self.friction_coefficient, self.reference_pressure, self.exponent]);
base__check(simple___is_friction(mu), [(0.0 < p && p < Infinity), "reference_pressure", ("" + $format(p, ("" + "g")) + " Pa"), ("" + "the pressure " + $str("must be positive and finite"))], [(0.0 <= n && n < 1.0), "exponent", ("" + $format(n, ("" + "g"))), "the exponent must lie in 0 <= n < 1"]);
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
$sig(PressurePower, ["slip_includes", "friction_coefficient", "reference_pressure", "exponent", "tested"], false, {slip_includes: () => null, tested: () => null});
class ClassicalDrive extends $Object {
}
$sig(ClassicalDrive, ["design", "ratio", "wrap_factor", "slack_tension", "slipping_arc"], false, {});
class Input extends $Object {
text() {
const self = this; let digits;

if (((self.value == null) || $truth($b.isinstance(self.value, "str")))) {
return $b.str($bound(self, "value"));
}
if ($truth($math.isinf($bound(self, "value")))) {
return "rigid";
}
(digits = ((self.origin == null) ? 3 : 4));
return cell__quantity($bound(self, "value"), $bound(self, "dimension"), digits, $bound(self, "name"));
}
note(of) {
const self = this; let origin;

(origin = ((self.origin == null) ? "" : of.note($bound(self, "origin"))));
return $m.join("; ", (function* () { for (const part of $iter([origin, self.remark])) { if (!($truth(part))) continue; yield part; } })());
}
}
$sig(Input, ["group", "title", "value", "dimension", "symbol", "origin", "remark", "name"], false, {dimension: () => "number", symbol: () => "", origin: () => $c81, remark: () => "", name: () => ""});
class Sources extends $Object {
$init() {
const self = this; (self._numbers = $map([]));
}
note(provenance) {
const self = this; let kind, number, origin;

(origin = $m.join(", ", (function* () { for (const part of $iter([provenance.source, provenance.date])) { if (!($truth(part))) continue; yield part; } })()));
if (!$truth(origin)) {
(kind = ((provenance.kind === "given") ? "" : $b.str($bound(provenance, "kind"))));
} else {
(number = $m.setdefault(self._numbers, origin, $add($b.len($bound(self, "_numbers")), 1)));
(kind = ("" + $str(provenance.kind) + " [" + $str(number) + "]"));
}
return $m.join(", ", (function* () { for (const part of $iter([kind, provenance.note])) { if (!($truth(part))) continue; yield part; } })());
}
number(text) {
const self = this; 
return ($truth(text) ? ("" + "[" + $str($m.setdefault(self._numbers, text, $add($b.len($bound(self, "_numbers")), 1))) + "]") : "");
}
listed() {
const self = this; 
return $b.tuple($bound(self, "_numbers"));
}
}
class TestedRange extends $Object {
__post_init__() {
const self = this; base__check([(0.0 < self.pressure_min && self.pressure_min <= self.pressure_max && self.pressure_max < Infinity), "pressure", ("" + $format(self.pressure_min, ("" + "g")) + " .. " + $format(self.pressure_max, ("" + "g")) + " Pa"), "the tested pressures must be positive, finite and in order"], [(0.0 < self.slip_max && self.slip_max < Infinity), "slip_max", ("" + $format(self.slip_max, ("" + "g")) + " m"), "the largest tested slip must be positive and finite"], [$or((self.slip_speed == null), () => (0.0 < self.slip_speed && self.slip_speed < Infinity)), "slip_speed", ("" + $str(self.slip_speed) + " m/s"), "the speed of slip in the tests must be positive and finite"]);
}
}
$sig(TestedRange, ["pressure_min", "pressure_max", "slip_max", "slip_speed"], false, {slip_speed: () => null});
class MeasuredTable extends FrictionLaw {
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
$sig(MeasuredTable, ["slip_includes", "slip", "pressure", "values"], false, {slip_includes: () => null});
class _Term extends $Tuple {
}
$sig(_Term, ["coefficient", "function", "power", "exponent"], false, {});
class Trend extends $Object {
__post_init__() {
const self = this; let n;
(n = $b.len($bound(self, "coefficients")));
base__check([($in(self.form, $c861)), "form", self.form, ("" + "the form must be one of " + $str($m.join(", ", $c861)))], [(1 <= n && n <= 4), "coefficients", $b.str(n), "one to four coefficients are needed"], [$b.all($b.map($math.isfinite, $bound(self, "coefficients"))), "coefficients", $b.str($bound(self, "coefficients")), "must be finite"], [($in(self.sign, [1, $neg(1)])), "sign", $b.str($bound(self, "sign")), "the sign must be 1 or -1"]);
}
at(pressure) {
const self = this; let c, exponential, logarithmic, v, y;

([logarithmic, exponential] = $at($c861, self.form));
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

([logarithmic, exponential] = $at($c861, self.form));
(c = $add(self.coefficients, $mul([0.0], $sub(4, $b.len($bound(self, "coefficients"))))));
return [...$iter(c), $b.float(logarithmic), ($truth(exponential) ? $b.float($bound(self, "sign")) : 0.0)];
}
}
$sig(Trend, ["form", "coefficients", "sign"], false, {form: () => "polynomial", sign: () => 1});
class Piece extends $Object {
}
$sig(Piece, ["a", "b", "post_peak_slope", "residual_friction"], false, {post_peak_slope: () => $c113, residual_friction: () => $c114});
class CoefficientPieces extends $Object {
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
$sig(CoefficientPieces, ["pressure", "pieces", "slip_unit", "continuity"], false, {slip_unit: () => 1.0, continuity: () => 0.02});
class PressureKnots extends $Object {
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
$sig(PressureKnots, ["pressure", "peak_friction", "peak_slip", "post_peak_slope", "residual_friction"], false, {post_peak_slope: () => [], residual_friction: () => []});
class IntegralLog extends FrictionLaw {
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
$sig(IntegralLog, ["slip_includes", "coefficients", "tested"], false, {slip_includes: () => null, tested: () => null});
class Factors extends $Object {
__post_init__() {
const self = this; limits__raise_all([...$iter(factors___outside("slip_speed", $bound(self, "slip_speed"), $bound(self, "by_slip_speed"), "speed")), ...$iter(factors___outside("temperature", $bound(self, "temperature"), $bound(self, "by_temperature"), "temperature"))]);
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
}
$sig(Factors, ["law", "by_slip_speed", "by_temperature", "slip_speed", "temperature"], false, {by_slip_speed: () => null, by_temperature: () => null, slip_speed: () => null, temperature: () => null});
class Lagging extends Viewable {
__post_init__() {
const self = this; let message, problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__name_problems("condition", $bound(self, "condition"))));
(problems = $add(problems, limits__limit_problems(self, $bound(self, "LIMITS"))));
if (($truth(self.surface) && (!$in(self.surface, $c862)))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c862))));
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
$sig(Lagging, ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "block", "provenance", "sources", "notes", "description"], false, {thickness: () => 0.0, shear_modulus: () => Infinity, compression_modulus: () => Infinity, title: () => "", condition: () => "dry", surface: () => "", elastic_modulus: () => null, wear_coefficient: () => null, belt_energy_share: () => null, bond_strength: () => null, fatigue_limit: () => null, cost: () => null, fit: () => null, factors: () => null, condition_factors: () => new Map(), block: () => null, provenance: () => new Provenance(), sources: () => new Map(), notes: () => [], description: () => ""});
class LoadGiven extends $Tuple {
}
$sig(LoadGiven, ["entry_tension", "exit_tension", "effective_tension", "torque", "power"], false, {entry_tension: () => null, exit_tension: () => null, effective_tension: () => null, torque: () => null, power: () => null});
class DrumAt extends $Tuple {
}
$sig(DrumAt, ["diameter", "speed"], false, {});
class Pair extends $Tuple {
}
$sig(Pair, ["entry", "exit"], false, {});
class TorqueFollower extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(TorqueFollower, ["master", "ratio"], false, {ratio: () => 1.0});
class TrainCase extends $Object {
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
$sig(TrainCase, ["name", "entry_tension", "exit_tension", "division", "runs", "kind", "condition"], false, {runs: () => [], kind: () => "running", condition: () => ""});
class RunsGain extends $Tuple {
}
$sig(RunsGain, ["base", "case"], false, {base: () => 0.0, case: () => 0.0});
class BehindTakeUp extends $Tuple {
}
$sig(BehindTakeUp, ["share", "behind", "runs"], false, {});
class OfBelt extends $Dict {
}
class Description extends $Tuple {
}
$sig(Description, ["entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "belt_speed", "wear_coefficient", "shear_compliance", "pitch_offset", "centrifugal"], false, {});
class CompactLaw extends $Tuple {
}
$sig(CompactLaw, ["kind", "edges", "coefficients", "slips", "onset_compliance"], false, {slips: () => [], onset_compliance: () => 0.0});
class TakeUp extends $Object {
__post_init__() {
const self = this; let given, message, problems, remedy;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, criteria__choice_problems(self, $map([["kind", ["", ...$iter($c863)]]]))));
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
$sig(TakeUp, ["kind", "sheave_ratio", "after"], false, {kind: () => "", sheave_ratio: () => 2.0, after: () => ""});
class DesignStandard extends $Object {
__post_init__() {
const self = this; let given, message, problems, remedy, words;
(words = $map([["name", ["", ...$iter($c864)]], ["condition", ["", ...$iter($c865)]]]));
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
$sig(DesignStandard, ["name", "condition", "friction", "start_factor", "binding"], false, {name: () => "", condition: () => "", friction: () => null, start_factor: () => 1.0, binding: () => false});
class SafetyFactors extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
of(kind) {
const self = this; 
return $b.float($b.getattr(self, kind));
}
}
$sig(SafetyFactors, ["running", "starting", "braking", "source"], false, {running: () => 1.25, starting: () => 1.1, braking: () => 1.1, source: () => ""});
class Kind extends $Object {
built(value, report, more = new Map()) {
const self = this; 
return value;
}
}
class tables$Table extends Kind {
get _fields() { return $kept(this, "_fields", this.$find__fields()); }
$init(title, ...entries) {
const self = this; const {of: of = null, on_one_line: on_one_line = false} = $named(entries);
([self.title, self.of, self.on_one_line] = [title, of, on_one_line]);
(self.entries = $b.tuple((function* () { for (const e of $iter(entries)) { yield ((e.kind === $c866) ? $replaced(e, new Map([["kind", tables___kind_of(of, $bound(e, "attribute"))]])) : e); } })()));
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
__post_init__() {
const self = this; (self.title = $or(self.title, () => $m.capitalize($m.replace(self.key, "_", " "))));
(self.attribute = $or(self.attribute, () => self.key));
}
}
$sig(Entry, ["key", "meaning", "kind", "title", "required", "alias", "example", "attribute", "unless", "stated"], false, {meaning: () => "", kind: () => $c866, title: () => "", required: () => false, alias: () => "", example: () => "", attribute: () => "", unless: () => "", stated: () => false});
class Name extends Kind {
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
$sig(Name, ["longest"], false, {longest: () => 60});
class Text extends Kind {
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "str"))) {
report.add(place, "must be text", "Put it in quotes.", raw);
} else {
if (($b.len(raw) > self.longest)) {
report.add(place, ("" + "longer than " + $str(self.longest) + " characters"), "Shorten it.", raw);
} else {
if (!$truth($m.isprintable(($truth(self.lines) ? $m.translate(raw, $c867) : raw)))) {
report.add(place, "holds characters that cannot be printed", "Remove them.", raw);
} else {
return raw;
}
}
}
return $c7;
}
}
$sig(Text, ["longest", "lines"], false, {longest: () => 200, lines: () => false});
class Quantity extends Kind {
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
$sig(Quantity, ["dimension", "limit"], false, {limit: () => null});
class Limit extends $Object {
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
$sig(Limit, ["dimension", "least", "most", "open", "rigid"], false, {least: () => 0.0, most: () => Infinity, open: () => false, rigid: () => false});
class WordOr extends Kind {
read(raw, place, report) {
const self = this; 
return (($eq(raw, self.word)) ? self.meaning : self.kind.read(raw, place, report));
}
}
$sig(WordOr, ["word", "kind", "meaning"], false, {meaning: () => null});
class ByName extends Kind {
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
$sig(ByName, ["kind", "most"], false, {most: () => 200});
class Belt extends $Object {
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
const self = this; let bare, found, told;

(found = $m.search($c868, $m.upper($m.strip(self.name))));
if (((self.strength != null) || (found == null))) {
return self.strength;
}
(told = $b.float($at(found, 1)));
(bare = $m.startswith($m.strip(self.name), $at(found, 1)));
if (($truth(bare) && (self.rating != null) && ($b.abs($sub((self.rating / $mul(told, 175.12683524647636)), 1.0)) < 0.02))) {
return null;
}
return $mul(1000.0, told);
}
get axial_stiffness() {
const self = this; 
return $mul(self.modulus, self.width);
}
}
$sig(Belt, ["name", "width", "modulus", "rating", "strength", "speed", "kind", "momentary_factor", "least_pulley_diameter", "largest_wrap_pressure", "in_plane_shear_stiffness", "pulley_cover", "carry_cover", "carcass", "thickness", "cover_shear_modulus", "mass", "provenance", "sources"], false, {rating: () => null, strength: () => null, speed: () => null, kind: () => "", momentary_factor: () => null, least_pulley_diameter: () => null, largest_wrap_pressure: () => null, in_plane_shear_stiffness: () => null, pulley_cover: () => null, carry_cover: () => null, carcass: () => null, thickness: () => null, cover_shear_modulus: () => null, mass: () => null, provenance: () => new Provenance(), sources: () => new Map()});
class _Nothing extends $Object {
}
class TextOr extends Kind {
read(raw, place, report) {
const self = this; 
return ($truth($b.isinstance(raw, "dict")) ? self.table : self.text).read(raw, place, report);
}
}
$sig(TextOr, ["text", "table"], false, {});
class Flag extends Kind {
read(raw, place, report) {
const self = this; 
if ($truth($b.isinstance(raw, "bool"))) {
return raw;
}
report.add(place, "must be true or false", "Write it without quotes.", raw);
return $c7;
}
}
$sig(Flag, [], false, {});
class Choice extends Kind {
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
$sig(Choice, ["options"], false, {});
class Across extends $Object {
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
profiles() {
const self = this; let found;

(found = $map([...(function* () { for (const f of $iter($fields(self))) { yield [f.name, $b.getattr(self, $bound(f, "name"))]; } })()]));
return $map([...(function* () { for (const [k, v] of $iter($m.items(found))) { if (!($truth($b.isinstance(v, WidthProfile)))) continue; yield [k, v]; } })()]);
}
problems(key, width) {
const self = this; let found;

(found = [...(function* () { for (const [name, profile] of $iter($m.items(self.profiles()))) { for (const problem of $iter(profile.problems(("" + $str(key) + "." + $str(name)), width))) { yield problem; }} })()]);
if (($truth($b.isinstance(self.before, Transition)) && (self.before.centre_roll >= width))) {
$m.append(found, new Problem(("" + "wider than the belt, " + $str(display__display(width, "length"))), "Give the width of belt on the centre roll.", undefined, ("" + $str(key) + ".before.centre_roll"), display__display($bound(self.before, "centre_roll"), "length")));
}
return found;
}
}
$sig(Across, ["shell_profile", "worn_depth", "build_up", "misalignment", "deflection", "entry_profile", "before", "after", "strips"], false, {shell_profile: () => null, worn_depth: () => null, build_up: () => null, misalignment: () => 0.0, deflection: () => 0.0, entry_profile: () => null, before: () => null, after: () => null, strips: () => 32});
class DimensionText extends $Tuple {
}
$sig(DimensionText, ["si_unit", "name", "example"], false, {});
class Definition extends $Tuple {
}
$sig(Definition, ["names", "factor", "unit", "zero"], false, {zero: () => $c875});
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
__post_init__() {
const self = this; let problems, worn;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
(problems = $add(problems, criteria__choice_problems(self, $map([["side", $c869]]))));
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
$sig(Pulley, ["name", "diameter", "wrap_angle", "lagging", "overrun", "recovery", "creep_limit", "side", "mass", "across", "sources", "conditions"], false, {overrun: () => null, recovery: () => true, creep_limit: () => null, side: () => "pulley", mass: () => null, across: () => null, sources: () => new Map(), conditions: () => []});
class Sag extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get tension() {
const self = this; 
return ($mul($mul(self.line_mass, 9.80665), self.spacing) / $mul(8.0, self.share));
}
}
$sig(Sag, ["spacing", "line_mass", "share"], false, {share: () => 0.02});
class Conveyor extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, conveyor__choices(new Set((function* () { for (const key of $iter(self.LIMITS)) { if (!(($b.getattr(self, key) != null))) continue; yield key; } })()))));
if ((!$in(self.drive_at, $c870))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c870))));
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
get material() {
const self = this; 
if ((self.material_mass != null)) {
return self.material_mass;
}
return (conveyor___known($bound(self, "capacity"), 0.0) / conveyor___known($bound(self, "speed"), 1.0));
}
sizes() {
const self = this; 
return [self.length, self.lift, self.belt_mass, self.carry_idler_mass, self.return_idler_mass, conveyor___known($bound(self, "material_mass"), NaN), conveyor___known($bound(self, "capacity"), NaN), self.friction_factor, conveyor___known($bound(self, "secondary_resistance"), NaN), (($eq(self.special_resistance, 0.0)) ? NaN : self.special_resistance), conveyor___known($bound(self, "start_time"), NaN), conveyor___known($bound(self, "stop_time"), NaN), conveyor___known($bound(self, "take_up_tension"), NaN), conveyor___known($bound(self, "counterweight"), NaN)];
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
return new conveyor$State(name, kind, resistances, head, tail, entry, leaving);
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
get _unusual() {
const self = this; let least, most;
([least, most] = $c1598);
if ((least <= self.friction_factor && self.friction_factor <= most)) {
return "";
}
return ("" + ", outside the usual " + $format(least, ("" + ".3f")) + " to " + $format(most, ("" + ".3f")));
}
}
$sig(Conveyor, ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio"], false, {lift: () => 0.0, material_mass: () => null, capacity: () => null, friction_factor: () => 0.02, length_coefficient: () => null, secondary_resistance: () => null, special_resistance: () => 0.0, return_share: () => 0.0, start_factor: () => null, start_time: () => null, stop_time: () => null, take_up_tension: () => null, counterweight: () => null, take_up_distance: () => 0.0, drive_at: () => "head", speed: () => null, sheave_ratio: () => 2.0});
class Rule extends $Object {
*checks(of) {
const self = this; let allowed, check, found, limit, missing, told, value, words;

if ((self.asked != null)) {
yield* $iter(self.asked(of));
return null;
}
(words = ($truth(self.words) ? self.words(of) : null));
(found = ($in(self.result, of.state.found)));
if (((words == null) || ($truth(self.result) && !$truth(found) && !$truth(of.unknown)))) {
return null;
}
(value = (($truth(self.result) && !$truth(found)) ? NaN : self.compared($bound(of, "state"))));
(missing = $or(words.missing, () => ($truth(self.result) ? of.unknown : "")));
(missing = $or(missing, () => ($truth($math.isnan(value)) ? "its value is not known" : "")));
if ($truth(missing)) {
(check = rule__not_checked($bound(self, "name"), $bound(words, "title"), missing, $bound(of, "place")));
(told = $replaced(check, new Map([["value", value], ["dimension", self.dimension]])));
yield ($truth(words.told) ? told : check);
return null;
}
(allowed = ($truth(self.allowed) ? self.allowed(of) : null));
(limit = self.limited(((allowed == null) ? NaN : allowed), $bound(of, "state")));
if ((self.rounded != null)) {
(value = self.rounded(value, limit, $bound(of, "state")));
}
yield self.held($bound(of, "drive")).judged(value, limit, $bound(of, "place"), words);
}
compared(state) {
const self = this; 
return ($truth(self.value) ? self.value(state) : $at(state.found, self.result));
}
limited(allowed, state) {
const self = this; 
return ((self.limit == null) ? allowed : self.limit(allowed, state));
}
held(drive) {
const self = this; let firm;

if ((self.firm == null)) {
return self;
}
(firm = self.firm(drive));
return $replaced(self, new Map([["missed", ($truth(firm) ? "FAILS" : self.missed)], ["binding", firm]]));
}
judged(value, limit, place, words) {
const self = this; let kept, level, miss, says;

(kept = $and(!$truth($math.isnan(value)), () => check__keeps(value, limit, self.at_most)));
(miss = new Miss($bound(self, "missed"), $bound(words, "short"), $bound(words, "says"), $bound(words, "remedy"), $bound(self, "fails_beyond"), $bound(words, "because"), $bound(self, "tolerates"), $bound(words, "allows"), $bound(words, "otherwise")));
([level, says] = miss.at(value, $bound(self, "at_most")));
return new Check(self.name, words.title, ($truth(kept) ? "OK" : level), place, value, limit, self.dimension, self.at_most, words.source, ($truth(kept) ? "" : words.short), ($truth(kept) ? "" : says), ($truth(kept) ? "" : words.remedy), ($truth(kept) ? "" : words.otherwise), words.more, self.binding, miss);
}
}
$sig(Rule, ["name", "what", "missed", "fails_beyond", "tolerates", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "allowed", "limit", "rounded", "pulls", "of_rows", "of_runs", "words", "asked"], false, {missed: () => "ATTENTION", fails_beyond: () => NaN, tolerates: () => NaN, at_most: () => true, dimension: () => "number", tension: () => "", binding: () => true, firm: () => null, result: () => "", value: () => null, allowed: () => null, limit: () => null, rounded: () => null, pulls: () => false, of_rows: () => true, of_runs: () => true, words: () => null, asked: () => null});
class DesignFriction extends $Object {
}
$sig(DesignFriction, ["standard", "surface", "condition", "friction", "provenance"], false, {});
class LaggingCost extends $Object {
}
$sig(LaggingCost, ["name", "surface", "material", "installation", "currency", "area", "life_years", "ten_year_cost", "provenance"], false, {});
class Cost extends $Object {
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
$sig(Cost, ["material", "installation", "currency", "area", "life_years"], false, {});
class Block extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.shape, $c872))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c872))));
$m.append(problems, new Problem(message, undefined, undefined, "shape", $shown($bound(self, "shape"))));
}
limits__raise_all(problems);
}
get shape_factor() {
const self = this; 
return compression__shape_factor(($eq(self.shape, "square")), $bound(self, "width"), $bound(self, "height"));
}
}
$sig(Block, ["shape", "width", "height", "stiffening", "contact_fraction"], false, {shape: () => "square", stiffening: () => 0.54, contact_fraction: () => 1.0});
class ConditionFactor extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(ConditionFactor, ["factor", "source"], false, {});
class FrictionFactor extends $Object {
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
$sig(FrictionFactor, ["at", "factor", "source"], false, {});
class Fit extends $Object {
get knots() { return $kept(this, "knots", this.$find_knots()); }
get log_covariance() { return $kept(this, "log_covariance", this.$find_log_covariance()); }
__post_init__() {
const self = this; let message, n, problems;
(n = $b.len($bound(self, "parameters")));
(problems = limits__limit_problems(self, $c873));
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

(found = [...(function* () { for (const name of $iter(self.parameters)) { yield $m.fullmatch($c874, name); } })()]);
if (($b.min($bound(self, "values")) <= 0.0)) {
return [];
}
(named = $b.tuple((function* () { for (const match of $iter(found)) { if (!($truth(match))) continue; yield [$sub($b.int($at(match, 1)), 1), $at(match, 2)]; } })()));
return (($eq($b.len(named), $b.len(found))) ? named : []);
}

}
$sig(Fit, ["parameters", "values", "covariance", "residual_noise", "date", "method", "misfit", "misfit_accepted", "coverage_factor"], false, {residual_noise: () => null, date: () => "", method: () => "", misfit: () => [], misfit_accepted: () => "", coverage_factor: () => 1.96});
class Induction extends Motor {
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
$sig(Induction, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, breakdown_ratio: () => 2.5});
class FluidCoupling extends Induction {
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
$sig(FluidCoupling, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio", "coupling_load", "coupling_slip"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, breakdown_ratio: () => 2.5});
class Load extends $Tuple {
}
$sig(Load, ["entry_tension", "exit_tension", "creep_limit", "pressure_min", "pressure_max", "slip_max", "steepest_fall"], false, {});
class Transition extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.depth, $c1313))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c1313))));
$m.append(problems, new Problem(message, undefined, undefined, "depth", $shown($bound(self, "depth"))));
}
limits__raise_all(problems);
}
}
$sig(Transition, ["length", "trough_angle", "centre_roll", "depth"], false, {depth: () => "full"});
class conveyor$State extends $Object {
get pull() {
const self = this; 
return $b.sum((function* () { for (const resistance of $iter(self.resistances)) { yield resistance.total; } })());
}
}
$sig(conveyor$State, ["name", "kind", "resistances", "head", "tail", "entry", "exit"], false, {});
class Resistance extends $Object {
get total() {
const self = this; 
return $add(self.carrying, self.returning);
}
}
$sig(Resistance, ["name", "carrying", "returning", "source"], false, {});
class Miss extends $Tuple {
at(value, at_most) {
const self = this; let says;

if ($truth(numbers__beyond(value, $bound(self, "fails_beyond"), at_most))) {
return ["FAILS", $m.rstrip(("" + $str(self.says) + " " + $str(self.because)))];
}
(says = ((value <= self.tolerates) ? ("" + $str(self.says) + " " + $str(self.allows)) : self.says));
return [self.level, $m.rstrip(says)];
}
}
$sig(Miss, ["level", "short", "says", "remedy", "fails_beyond", "because", "tolerates", "allows", "otherwise"], false, {fails_beyond: () => NaN, because: () => "", tolerates: () => NaN, allows: () => "", otherwise: () => ""});
class OneOrMore extends Kind {
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "list"))) {
return [self.kind.read(raw, place, report)];
}
return new Rows($bound(self, "kind"), 1, $bound(self, "most")).read(raw, place, report);
}
}
$sig(OneOrMore, ["kind", "most"], false, {most: () => 50});
class Rows extends Kind {
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
$sig(Rows, ["kind", "least", "most"], false, {least: () => 0, most: () => 1000});
class ElasticPlastic extends FrictionLaw {
__post_init__() {
const self = this; let k, mu;
([mu, k] = [self.friction_coefficient, self.stiffness]);
base__check(simple___is_friction(mu), [(0.0 < k && k < Infinity), "stiffness", ("" + $format(k, ("" + "g")) + " Pa/m"), ("" + "the stiffness " + $str("must be positive and finite"))]);
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
$sig(ElasticPlastic, ["slip_includes", "stiffness", "friction_coefficient", "tested"], false, {slip_includes: () => null, tested: () => null});
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
class GrippingPulley extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(GrippingPulley, ["distance"], false, {});
class Count extends Kind {
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
$sig(Count, ["least", "most"], false, {});
class Elsewhere extends Kind {
read(raw, place, report) {
const self = this; 
return raw;
}
}
$sig(Elsewhere, [], false, {});
class Either extends Kind {
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
$sig(Either, ["first", "second", "words"], false, {});
class SpeedList extends Kind {
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
$sig(SpeedList, [], false, {});
class _OfClass extends Kind {
read(raw, place, report) {
const self = this; 
throw $TypeError;
}
}
const $c883 = ["of", "entries", "_known"];
const $c898 = ["key", "kind", "required", "alias", "example", "attribute", "unless"];
const $c154 = ["dimension", "limit"];
const $c899 = $made(Quantity, $c154, ["number", null]);
const $c886 = $made(Entry, $c898, ["format", $c899, true, "", "format = 1", "format", ""]);
const $c901 = ["longest", "lines"];
const $c900 = $made(Text, $c901, [200, false]);
const $c887 = $made(Entry, $c898, ["title", $c900, false, "", "", "title", ""]);
const $c902 = $made(Text, $c901, [5000, true]);
const $c888 = $made(Entry, $c898, ["description", $c902, false, "", "", "description", ""]);
const $c904 = ["dimension", "least", "most", "open", "rigid"];
const $c834 = $made(Limit, $c904, ["length", 0.0, 1.0, true, false]);
const $c903 = $made(Quantity, $c154, ["length", $c834]);
const $c889 = $made(Entry, $c898, ["creep_limit", $c903, false, "", "", "creep_limit", ""]);
const $c906 = ["kind", "most"];
const $c907 = ["text", "table"];
const $c908 = ["longest"];
const $c218 = $made(Name, $c908, [60]);
const $c916 = $made(Name, $c908, [60]);
const $c911 = $made(Entry, $c898, ["name", $c916, true, "", "", "name", ""]);
const $c830 = $made(Limit, $c904, ["number", 0.0, 2.0, true, false]);
const $c917 = $made(Quantity, $c154, ["number", $c830]);
const $c912 = $made(Entry, $c898, ["friction_factor", $c917, false, "", "", "factor", ""]);
const $c918 = $made(ByName, $c906, [$c917, 200]);
const $c913 = $made(Entry, $c898, ["friction_factors", $c918, false, "", "", "friction_factors", ""]);
const $c920 = ["options"];
const $c921 = ["DIN 22101", "practice"];
const $c919 = $made(Choice, $c920, [$c921]);
const $c914 = $made(Entry, $c898, ["standard", $c919, false, "", "", "standard", ""]);
const $c929 = ["measured", "published", "calibrated", "illustrative", "given"];
const $c928 = $made(Choice, $c920, [$c929]);
const $c924 = $made(Entry, $c898, ["kind", $c928, true, "", "", "kind", ""]);
const $c930 = $made(Text, $c901, [500, false]);
const $c925 = $made(Entry, $c898, ["source", $c930, false, "", "", "source", ""]);
const $c931 = $made(Text, $c901, [60, false]);
const $c926 = $made(Entry, $c898, ["date", $c931, false, "", "", "date", ""]);
const $c932 = $made(Text, $c901, [1000, false]);
const $c927 = $made(Entry, $c898, ["note", $c932, false, "", "", "note", ""]);
const $c922 = [$c924, $c925, $c926, $c927];
const $c923 = new Map([["kind", $c924], ["source", $c925], ["date", $c926], ["note", $c927]]);
const $c2 = $made(tables$Table, $c883, [Provenance, $c922, $c923]);
const $c915 = $made(Entry, $c898, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c909 = [$c911, $c912, $c913, $c914, $c915];
const $c910 = new Map([["name", $c911], ["friction_factor", $c912], ["friction_factors", $c913], ["standard", $c914], ["provenance", $c915]]);
const $c8 = $made(tables$Table, $c883, [Condition, $c909, $c910]);
const $c217 = $made(TextOr, $c907, [$c218, $c8]);
const $c905 = $made(OneOrMore, $c906, [$c217, 8]);
const $c890 = $made(Entry, $c898, ["condition", $c905, false, "", "", "condition", ""]);
const $c150 = $made(Name, $c908, [60]);
const $c129 = $made(Entry, $c898, ["preset", $c150, false, "", "", "preset", ""]);
const $c151 = $made(Name, $c908, [60]);
const $c130 = $made(Entry, $c898, ["name", $c151, false, "", "", "name", ""]);
const $c152 = $made(Text, $c901, [60, false]);
const $c131 = $made(Entry, $c898, ["kind", $c152, false, "", "", "kind", ""]);
const $c155 = $made(Limit, $c904, ["length", 0.001, 1000.0, false, false]);
const $c153 = $made(Quantity, $c154, ["length", $c155]);
const $c132 = $made(Entry, $c898, ["width", $c153, true, "", "", "width", ""]);
const $c934 = ["word", "kind", "meaning"];
const $c160 = $made(Limit, $c904, ["force_per_width", 1000.0, Infinity, false, true]);
const $c159 = $made(Quantity, $c154, ["force_per_width", $c160]);
const $c157 = $made(WordOr, $c934, ["rigid", $c159, Infinity]);
const $c133 = $made(Entry, $c898, ["modulus", $c157, false, "", "", "modulus", ""]);
const $c162 = $made(Limit, $c904, ["force_per_width", 0.0, Infinity, true, false]);
const $c161 = $made(Quantity, $c154, ["force_per_width", $c162]);
const $c134 = $made(Entry, $c898, ["rating", $c161, false, "", "", "rating", ""]);
const $c164 = $made(Limit, $c904, ["force_per_width", 0.0, Infinity, true, false]);
const $c163 = $made(Quantity, $c154, ["force_per_width", $c164]);
const $c135 = $made(Entry, $c898, ["strength", $c163, false, "", "", "strength", ""]);
const $c166 = $made(Limit, $c904, ["speed", 0.0, 1000.0, true, false]);
const $c165 = $made(Quantity, $c154, ["speed", $c166]);
const $c136 = $made(Entry, $c898, ["speed", $c165, false, "", "", "speed", ""]);
const $c168 = $made(Limit, $c904, ["number", 1.0, 10.0, false, false]);
const $c167 = $made(Quantity, $c154, ["number", $c168]);
const $c137 = $made(Entry, $c898, ["momentary_factor", $c167, false, "", "", "momentary_factor", ""]);
const $c170 = $made(Limit, $c904, ["length", 0.0, Infinity, true, false]);
const $c169 = $made(Quantity, $c154, ["length", $c170]);
const $c138 = $made(Entry, $c898, ["least_pulley_diameter", $c169, false, "", "", "least_pulley_diameter", ""]);
const $c172 = $made(Limit, $c904, ["pressure", 0.0, Infinity, true, false]);
const $c171 = $made(Quantity, $c154, ["pressure", $c172]);
const $c139 = $made(Entry, $c898, ["largest_wrap_pressure", $c171, false, "", "", "largest_wrap_pressure", ""]);
const $c174 = $made(Limit, $c904, ["force_per_width", 1.0, 1000000000.0, false, false]);
const $c173 = $made(Quantity, $c154, ["force_per_width", $c174]);
const $c140 = $made(Entry, $c898, ["in_plane_shear_stiffness", $c173, false, "", "", "in_plane_shear_stiffness", ""]);
const $c176 = $made(Limit, $c904, ["length", 0.0, 0.06, false, false]);
const $c175 = $made(Quantity, $c154, ["length", $c176]);
const $c141 = $made(Entry, $c898, ["pulley_cover", $c175, false, "", "", "pulley_cover", ""]);
const $c178 = $made(Limit, $c904, ["length", 0.0, 0.06, false, false]);
const $c177 = $made(Quantity, $c154, ["length", $c178]);
const $c142 = $made(Entry, $c898, ["carry_cover", $c177, false, "", "", "carry_cover", ""]);
const $c180 = $made(Limit, $c904, ["length", 0.0, 0.06, true, false]);
const $c179 = $made(Quantity, $c154, ["length", $c180]);
const $c143 = $made(Entry, $c898, ["carcass", $c179, false, "", "", "carcass", ""]);
const $c182 = $made(Limit, $c904, ["length", 0.0, 0.06, true, false]);
const $c181 = $made(Quantity, $c154, ["length", $c182]);
const $c144 = $made(Entry, $c898, ["thickness", $c181, false, "", "", "thickness", ""]);
const $c185 = $made(Limit, $c904, ["pressure", 100000.0, 100000000.0, false, true]);
const $c184 = $made(Quantity, $c154, ["pressure", $c185]);
const $c183 = $made(WordOr, $c934, ["rigid", $c184, Infinity]);
const $c145 = $made(Entry, $c898, ["cover_shear_modulus", $c183, false, "", "", "cover_shear_modulus", ""]);
const $c187 = $made(Limit, $c904, ["mass_per_length", 0.0, 1000000.0, true, false]);
const $c186 = $made(Quantity, $c154, ["mass_per_length", $c187]);
const $c146 = $made(Entry, $c898, ["mass", $c186, false, "", "", "mass", ""]);
const $c147 = $made(Entry, $c898, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c188 = $made(ByName, $c906, [$c2, 200]);
const $c148 = $made(Entry, $c898, ["sources", $c188, false, "", "", "sources", ""]);
const $c1 = [$c129, $c130, $c131, $c132, $c133, $c134, $c135, $c136, $c137, $c138, $c139, $c140, $c141, $c142, $c143, $c144, $c145, $c146, $c147, $c148];
const $c933 = new Map([["preset", $c129], ["name", $c130], ["kind", $c131], ["width", $c132], ["modulus", $c133], ["rating", $c134], ["strength", $c135], ["speed", $c136], ["momentary_factor", $c137], ["least_pulley_diameter", $c138], ["largest_wrap_pressure", $c139], ["in_plane_shear_stiffness", $c140], ["pulley_cover", $c141], ["carry_cover", $c142], ["carcass", $c143], ["thickness", $c144], ["cover_shear_modulus", $c145], ["mass", $c146], ["provenance", $c147], ["sources", $c148]]);
const $c5 = $made(tables$Table, $c883, [Belt, $c1, $c933]);
const $c891 = $made(Entry, $c898, ["belt", $c5, true, "", "a [belt] table", "belt", ""]);
const $c936 = ["kind", "least", "most"];
const $c208 = $made(Name, $c908, [60]);
const $c190 = $made(Entry, $c898, ["name", $c208, true, "", "name = \"head\"", "name", ""]);
const $c210 = $made(Limit, $c904, ["length", 0.001, 1000.0, false, false]);
const $c209 = $made(Quantity, $c154, ["length", $c210]);
const $c191 = $made(Entry, $c898, ["diameter", $c209, true, "", "", "diameter", ""]);
const $c212 = $made(Limit, $c904, ["angle", 0.017453292519943295, 12.566370614359172, false, false]);
const $c211 = $made(Quantity, $c154, ["angle", $c212]);
const $c192 = $made(Entry, $c898, ["wrap_angle", $c211, true, "wrap", "", "wrap_angle", "belt_path"]);
const $c831 = $made(Limit, $c904, ["length", -100000.0, 100000.0, false, false]);
const $c945 = $made(Quantity, $c154, ["length", $c831]);
const $c940 = $made(Entry, $c898, ["x", $c945, true, "", "", "x", ""]);
const $c946 = $made(Quantity, $c154, ["length", $c831]);
const $c941 = $made(Entry, $c898, ["y", $c946, true, "", "", "y", ""]);
const $c948 = ["clockwise", "counterclockwise"];
const $c947 = $made(Choice, $c920, [$c948]);
const $c942 = $made(Entry, $c898, ["turn", $c947, false, "", "", "turn", ""]);
const $c955 = $made(Quantity, $c154, ["length", $c831]);
const $c952 = $made(Entry, $c898, ["x", $c955, true, "", "", "x", ""]);
const $c956 = $made(Quantity, $c154, ["length", $c831]);
const $c953 = $made(Entry, $c898, ["y", $c956, true, "", "", "y", ""]);
const $c832 = $made(Limit, $c904, ["length", 0.0, 1000.0, false, false]);
const $c957 = $made(Quantity, $c154, ["length", $c832]);
const $c954 = $made(Entry, $c898, ["diameter", $c957, false, "", "", "diameter", ""]);
const $c950 = [$c952, $c953, $c954, $c942];
const $c951 = new Map([["x", $c952], ["y", $c953], ["diameter", $c954], ["turn", $c942]]);
const $c949 = $made(tables$Table, $c883, [Point, $c950, $c951]);
const $c943 = $made(Entry, $c898, ["before", $c949, true, "", "a table with x and y", "before", ""]);
const $c944 = $made(Entry, $c898, ["after", $c949, true, "", "a table with x and y", "after", ""]);
const $c938 = [$c940, $c941, $c942, $c943, $c944];
const $c939 = new Map([["x", $c940], ["y", $c941], ["turn", $c942], ["before", $c943], ["after", $c944]]);
const $c213 = $made(tables$Table, $c883, [Point, $c938, $c939]);
const $c193 = $made(Entry, $c898, ["belt_path", $c213, false, "", "", "belt_path", ""]);
const $c216 = $made(Name, $c908, [500]);
const $c981 = $made(Name, $c908, [500]);
const $c961 = $made(Entry, $c898, ["preset", $c981, false, "", "", "preset", ""]);
const $c982 = $made(Name, $c908, [60]);
const $c962 = $made(Entry, $c898, ["name", $c982, false, "", "", "name", ""]);
const $c983 = $made(Text, $c901, [200, false]);
const $c963 = $made(Entry, $c898, ["title", $c983, false, "", "", "title", ""]);
const $c984 = $made(Text, $c901, [5000, true]);
const $c964 = $made(Entry, $c898, ["description", $c984, false, "", "", "description", ""]);
const $c862 = ["bare", "rubber", "polyurethane", "ceramic"];
const $c985 = $made(Choice, $c920, [$c862]);
const $c965 = $made(Entry, $c898, ["surface", $c985, false, "", "", "surface", ""]);
const $c845 = $made(Limit, $c904, ["length", 0.0, 1.0, false, false]);
const $c986 = $made(Quantity, $c154, ["length", $c845]);
const $c966 = $made(Entry, $c898, ["thickness", $c986, false, "", "", "thickness", ""]);
const $c848 = $made(Limit, $c904, ["pressure", 1000.0, Infinity, false, false]);
const $c987 = $made(Quantity, $c154, ["pressure", $c848]);
const $c967 = $made(Entry, $c898, ["elastic_modulus", $c987, false, "", "", "elastic_modulus", ""]);
const $c846 = $made(Limit, $c904, ["pressure", 1000.0, Infinity, false, true]);
const $c989 = $made(Quantity, $c154, ["pressure", $c846]);
const $c988 = $made(WordOr, $c934, ["rigid", $c989, Infinity]);
const $c968 = $made(Entry, $c898, ["shear_modulus", $c988, false, "", "", "shear_modulus", ""]);
const $c847 = $made(Limit, $c904, ["pressure", 1000.0, Infinity, false, true]);
const $c991 = $made(Quantity, $c154, ["pressure", $c847]);
const $c990 = $made(WordOr, $c934, ["rigid", $c991, Infinity]);
const $c969 = $made(Entry, $c898, ["compression_modulus", $c990, false, "", "", "compression_modulus", ""]);
const $c872 = ["square", "strip"];
const $c999 = $made(Choice, $c920, [$c872]);
const $c994 = $made(Entry, $c898, ["shape", $c999, false, "", "", "shape", ""]);
const $c818 = $made(Limit, $c904, ["length", 0.0001, 10.0, false, false]);
const $c1000 = $made(Quantity, $c154, ["length", $c818]);
const $c995 = $made(Entry, $c898, ["width", $c1000, true, "", "", "width", ""]);
const $c819 = $made(Limit, $c904, ["length", 0.0001, 1.0, false, false]);
const $c1001 = $made(Quantity, $c154, ["length", $c819]);
const $c996 = $made(Entry, $c898, ["height", $c1001, false, "", "", "height", ""]);
const $c820 = $made(Limit, $c904, ["number", 0.0, 10.0, false, false]);
const $c1002 = $made(Quantity, $c154, ["number", $c820]);
const $c997 = $made(Entry, $c898, ["stiffening", $c1002, false, "", "", "stiffening", ""]);
const $c821 = $made(Limit, $c904, ["number", 0.01, 1.0, false, false]);
const $c1003 = $made(Quantity, $c154, ["number", $c821]);
const $c998 = $made(Entry, $c898, ["contact_fraction", $c1003, false, "", "", "contact_fraction", ""]);
const $c992 = [$c994, $c995, $c996, $c997, $c998];
const $c993 = new Map([["shape", $c994], ["width", $c995], ["height", $c996], ["stiffening", $c997], ["contact_fraction", $c998]]);
const $c91 = $made(tables$Table, $c883, [Block, $c992, $c993]);
const $c970 = $made(Entry, $c898, ["block", $c91, false, "", "", "block", ""]);
const $c849 = $made(Limit, $c904, ["wear_coefficient", 0.0, 1.0, false, false]);
const $c1004 = $made(Quantity, $c154, ["wear_coefficient", $c849]);
const $c971 = $made(Entry, $c898, ["wear_coefficient", $c1004, false, "", "", "wear_coefficient", ""]);
const $c850 = $made(Limit, $c904, ["number", 0.0, 1.0, false, false]);
const $c1005 = $made(Quantity, $c154, ["number", $c850]);
const $c972 = $made(Entry, $c898, ["belt_energy_share", $c1005, false, "", "", "belt_energy_share", ""]);
const $c851 = $made(Limit, $c904, ["pressure", 0.0, Infinity, true, false]);
const $c1006 = $made(Quantity, $c154, ["pressure", $c851]);
const $c973 = $made(Entry, $c898, ["bond_strength", $c1006, false, "", "", "bond_strength", ""]);
const $c852 = $made(Limit, $c904, ["pressure", 0.0, Infinity, true, false]);
const $c1007 = $made(Quantity, $c154, ["pressure", $c852]);
const $c974 = $made(Entry, $c898, ["fatigue_limit", $c1007, false, "", "", "fatigue_limit", ""]);
const $c1016 = $made(Limit, $c904, ["number", 0.0, Infinity, false, false]);
const $c1015 = $made(Quantity, $c154, ["number", $c1016]);
const $c1010 = $made(Entry, $c898, ["material", $c1015, true, "", "", "material", ""]);
const $c1018 = $made(Limit, $c904, ["number", 0.0, Infinity, false, false]);
const $c1017 = $made(Quantity, $c154, ["number", $c1018]);
const $c1011 = $made(Entry, $c898, ["installation", $c1017, true, "", "", "installation", ""]);
const $c1019 = $made(Name, $c908, [12]);
const $c1012 = $made(Entry, $c898, ["currency", $c1019, true, "", "", "currency", ""]);
const $c1021 = $made(Limit, $c904, ["area", 0.0, Infinity, true, false]);
const $c1020 = $made(Quantity, $c154, ["area", $c1021]);
const $c1013 = $made(Entry, $c898, ["area", $c1020, true, "", "", "area", ""]);
const $c1023 = $made(Quantity, $c154, ["number", null]);
const $c1022 = $made(Rows, $c936, [$c1023, 2, 2]);
const $c1014 = $made(Entry, $c898, ["life_years", $c1022, true, "", "", "life_years", ""]);
const $c1008 = [$c1010, $c1011, $c1012, $c1013, $c1014];
const $c1009 = new Map([["material", $c1010], ["installation", $c1011], ["currency", $c1012], ["area", $c1013], ["life_years", $c1014]]);
const $c87 = $made(tables$Table, $c883, [Cost, $c1008, $c1009]);
const $c975 = $made(Entry, $c898, ["cost", $c87, false, "", "", "cost", ""]);
const $c1025 = $made(Limit, $c904, ["speed", 0.0, Infinity, true, false]);
const $c1024 = $made(Quantity, $c154, ["speed", $c1025]);
const $c976 = $made(Entry, $c898, ["slip_speed", $c1024, false, "", "", "slip_speed", ""]);
const $c1027 = $made(Limit, $c904, ["temperature", 0.0, Infinity, false, false]);
const $c1026 = $made(Quantity, $c154, ["temperature", $c1027]);
const $c977 = $made(Entry, $c898, ["temperature", $c1026, false, "", "", "temperature", ""]);
const $c1034 = $made(Name, $c908, [60]);
const $c1031 = $made(Entry, $c898, ["condition", $c1034, true, "", "", "condition", ""]);
const $c1036 = $made(Limit, $c904, ["number", 0.0, 10.0, true, false]);
const $c1035 = $made(Quantity, $c154, ["number", $c1036]);
const $c1032 = $made(Entry, $c898, ["factor", $c1035, true, "", "", "factor", ""]);
const $c1033 = $made(Entry, $c898, ["provenance", $c2, true, "", "", "provenance", ""]);
const $c1029 = [$c1031, $c1032, $c1033];
const $c1030 = new Map([["condition", $c1031], ["factor", $c1032], ["provenance", $c1033]]);
const $c92 = $made(tables$Table, $c883, [ConditionFactor, $c1029, $c1030]);
const $c1028 = $made(Rows, $c936, [$c92, 0, 20]);
const $c978 = $made(Entry, $c898, ["condition_factor", $c1028, false, "", "", "condition_factor", ""]);
const $c1038 = ["tag", "tables"];
const $c1065 = ["integral-log"];
const $c1064 = $made(Choice, $c920, [$c1065]);
const $c1047 = $made(Entry, $c898, ["kind", $c1064, true, "", "", "kind", ""]);
const $c1066 = $made(Name, $c908, [60]);
const $c1048 = $made(Entry, $c898, ["condition", $c1066, false, "", "", "condition", ""]);
const $c1049 = $made(Entry, $c898, ["provenance", $c2, false, "", "", "provenance", ""]);
const $c1050 = $made(Entry, $c898, ["condition_source", $c2, false, "", "", "condition_source", ""]);
const $c1079 = $made(Name, $c908, [120]);
const $c1078 = $made(Rows, $c936, [$c1079, 1, 1000]);
const $c1069 = $made(Entry, $c898, ["parameters", $c1078, true, "", "", "parameters", ""]);
const $c1080 = $made(Rows, $c936, [$c1023, 1, 1000]);
const $c1070 = $made(Entry, $c898, ["values", $c1080, true, "", "", "values", ""]);
const $c1082 = $made(Rows, $c936, [$c1023, 1, 1000]);
const $c1081 = $made(Rows, $c936, [$c1082, 1, 1000]);
const $c1071 = $made(Entry, $c898, ["covariance", $c1081, true, "", "", "covariance", ""]);
const $c1084 = $made(Limit, $c904, ["number", 0.0, Infinity, false, false]);
const $c1083 = $made(Quantity, $c154, ["number", $c1084]);
const $c1072 = $made(Entry, $c898, ["residual_noise", $c1083, false, "", "", "residual_noise", ""]);
const $c1086 = $made(Limit, $c904, ["number", 1.0, Infinity, false, false]);
const $c1085 = $made(Quantity, $c154, ["number", $c1086]);
const $c1073 = $made(Entry, $c898, ["coverage_factor", $c1085, false, "", "", "coverage_factor", ""]);
const $c1087 = $made(Text, $c901, [60, false]);
const $c1074 = $made(Entry, $c898, ["date", $c1087, false, "", "", "date", ""]);
const $c1088 = $made(Text, $c901, [500, false]);
const $c1075 = $made(Entry, $c898, ["method", $c1088, false, "", "", "method", ""]);
const $c1090 = $made(Text, $c901, [2000, true]);
const $c1089 = $made(Rows, $c936, [$c1090, 0, 50]);
const $c1076 = $made(Entry, $c898, ["misfit", $c1089, false, "", "", "misfit", ""]);
const $c1091 = $made(Text, $c901, [500, false]);
const $c1077 = $made(Entry, $c898, ["misfit_accepted", $c1091, false, "", "", "misfit_accepted", ""]);
const $c1067 = [$c1069, $c1070, $c1071, $c1072, $c1073, $c1074, $c1075, $c1076, $c1077];
const $c1068 = new Map([["parameters", $c1069], ["values", $c1070], ["covariance", $c1071], ["residual_noise", $c1072], ["coverage_factor", $c1073], ["date", $c1074], ["method", $c1075], ["misfit", $c1076], ["misfit_accepted", $c1077]]);
const $c99 = $made(tables$Table, $c883, [Fit, $c1067, $c1068]);
const $c1051 = $made(Entry, $c898, ["fit", $c99, false, "", "", "fit", ""]);
const $c1094 = ["lagging shear", "cover shear"];
const $c1093 = $made(Choice, $c920, [$c1094]);
const $c1092 = $made(Rows, $c936, [$c1093, 0, 2]);
const $c1052 = $made(Entry, $c898, ["slip_includes", $c1092, false, "", "", "slip_includes", ""]);
const $c1101 = $made(Limit, $c904, ["speed", 0.0, Infinity, true, false]);
const $c1100 = $made(Quantity, $c154, ["speed", $c1101]);
const $c1099 = $made(Rows, $c936, [$c1100, 2, 100]);
const $c1097 = $made(Entry, $c898, ["slip_speed", $c1099, true, "", "", "at", ""]);
const $c1102 = $made(Rows, $c936, [$c1035, 2, 100]);
const $c1098 = $made(Entry, $c898, ["factor", $c1102, true, "", "", "factor", ""]);
const $c1095 = [$c1097, $c1098, $c1033];
const $c1096 = new Map([["slip_speed", $c1097], ["factor", $c1098], ["provenance", $c1033]]);
const $c97 = $made(tables$Table, $c883, [FrictionFactor, $c1095, $c1096]);
const $c1053 = $made(Entry, $c898, ["slip_speed_factor", $c97, false, "", "", "slip_speed_factor", ""]);
const $c1108 = $made(Limit, $c904, ["temperature", 0.0, Infinity, false, false]);
const $c1107 = $made(Quantity, $c154, ["temperature", $c1108]);
const $c1106 = $made(Rows, $c936, [$c1107, 2, 100]);
const $c1105 = $made(Entry, $c898, ["temperature", $c1106, true, "", "", "at", ""]);
const $c1103 = [$c1105, $c1098, $c1033];
const $c1104 = new Map([["temperature", $c1105], ["factor", $c1098], ["provenance", $c1033]]);
const $c98 = $made(tables$Table, $c883, [FrictionFactor, $c1103, $c1104]);
const $c1054 = $made(Entry, $c898, ["temperature_factor", $c98, false, "", "", "temperature_factor", ""]);
const $c1055 = $made(Entry, $c898, ["notes", $c1089, false, "", "", "notes", ""]);
const $c1111 = $made(Limit, $c904, ["pressure", 0.0, 1000000000.0, true, false]);
const $c1110 = $made(Quantity, $c154, ["pressure", $c1111]);
const $c1109 = $made(Rows, $c936, [$c1110, 2, 2]);
const $c1056 = $made(Entry, $c898, ["tested_pressure", $c1109, false, "", "", "tested_pressure", ""]);
const $c1113 = $made(Limit, $c904, ["length", 0.0, 1.0, true, false]);
const $c1112 = $made(Quantity, $c154, ["length", $c1113]);
const $c1057 = $made(Entry, $c898, ["tested_slip", $c1112, false, "", "", "tested_slip", ""]);
const $c1115 = $made(Limit, $c904, ["speed", 0.0, Infinity, true, false]);
const $c1114 = $made(Quantity, $c154, ["speed", $c1115]);
const $c1058 = $made(Entry, $c898, ["tested_slip_speed", $c1114, false, "", "", "tested_slip_speed", ""]);
const $c1120 = $made(Entry, $c898, ["pressure", $c1110, true, "", "", "pressure", ""]);
const $c1126 = $made(Limit, $c904, ["number", 0.0, 5.0, true, false]);
const $c1125 = $made(Quantity, $c154, ["number", $c1126]);
const $c1121 = $made(Entry, $c898, ["peak_friction", $c1125, true, "", "", "peak_friction", ""]);
const $c1122 = $made(Entry, $c898, ["peak_slip", $c1112, true, "", "", "peak_slip", ""]);
const $c1128 = $made(Limit, $c904, ["per_length", -1000000.0, 0.0, false, false]);
const $c1127 = $made(Quantity, $c154, ["per_length", $c1128]);
const $c1123 = $made(Entry, $c898, ["post_peak_slope", $c1127, false, "", "", "post_peak_slope", ""]);
const $c1124 = $made(Entry, $c898, ["residual_friction", $c1125, false, "", "", "residual_friction", ""]);
const $c1118 = [$c1120, $c1121, $c1122, $c1123, $c1124];
const $c1119 = new Map([["pressure", $c1120], ["peak_friction", $c1121], ["peak_slip", $c1122], ["post_peak_slope", $c1123], ["residual_friction", $c1124]]);
const $c1117 = $made(tables$Table, $c883, [null, $c1118, $c1119]);
const $c1116 = $made(Rows, $c936, [$c1117, 1, 200]);
const $c1059 = $made(Entry, $c898, ["knots", $c1116, false, "", "", "knots", ""]);
const $c1133 = $made(Entry, $c898, ["from", $c1110, true, "", "", "from", ""]);
const $c1134 = $made(Entry, $c898, ["to", $c1110, true, "", "", "to", ""]);
const $c1139 = $made(Text, $c901, [300, false]);
const $c1135 = $made(Entry, $c898, ["A", $c1139, true, "", "", "A", ""]);
const $c1136 = $made(Entry, $c898, ["b", $c1139, true, "", "", "b", ""]);
const $c1137 = $made(Entry, $c898, ["post_peak_slope", $c1139, false, "", "", "post_peak_slope", ""]);
const $c1138 = $made(Entry, $c898, ["residual_friction", $c1139, false, "", "", "residual_friction", ""]);
const $c1131 = [$c1133, $c1134, $c1135, $c1136, $c1137, $c1138];
const $c1132 = new Map([["from", $c1133], ["to", $c1134], ["A", $c1135], ["b", $c1136], ["post_peak_slope", $c1137], ["residual_friction", $c1138]]);
const $c1130 = $made(tables$Table, $c883, [null, $c1131, $c1132]);
const $c1129 = $made(Rows, $c936, [$c1130, 1, 50]);
const $c1060 = $made(Entry, $c898, ["pieces", $c1129, false, "", "", "pieces", ""]);
const $c1140 = $made(Text, $c901, [20, false]);
const $c1061 = $made(Entry, $c898, ["slip_unit", $c1140, false, "", "", "slip_unit", ""]);
const $c1141 = $made(Text, $c901, [20, false]);
const $c1062 = $made(Entry, $c898, ["pressure_unit", $c1141, false, "", "", "pressure_unit", ""]);
const $c1143 = $made(Limit, $c904, ["number", 0.0, 0.5, false, false]);
const $c1142 = $made(Quantity, $c154, ["number", $c1143]);
const $c1063 = $made(Entry, $c898, ["continuity", $c1142, false, "", "", "continuity", ""]);
const $c1045 = [$c1047, $c1048, $c1049, $c1050, $c1051, $c1052, $c1053, $c1054, $c1055, $c1056, $c1057, $c1058, $c1059, $c1060, $c1061, $c1062, $c1063];
const $c1046 = new Map([["kind", $c1047], ["condition", $c1048], ["provenance", $c1049], ["condition_source", $c1050], ["fit", $c1051], ["slip_includes", $c1052], ["slip_speed_factor", $c1053], ["temperature_factor", $c1054], ["notes", $c1055], ["tested_pressure", $c1056], ["tested_slip", $c1057], ["tested_slip_speed", $c1058], ["knots", $c1059], ["pieces", $c1060], ["slip_unit", $c1061], ["pressure_unit", $c1062], ["continuity", $c1063]]);
const $c1040 = $made(tables$Table, $c883, [IntegralLog, $c1045, $c1046]);
const $c1149 = ["constant"];
const $c1148 = $made(Choice, $c920, [$c1149]);
const $c1146 = $made(Entry, $c898, ["kind", $c1148, true, "", "", "kind", ""]);
const $c1147 = $made(Entry, $c898, ["friction", $c1125, true, "", "", "friction_coefficient", ""]);
const $c1144 = [$c1146, $c1048, $c1049, $c1050, $c1051, $c1052, $c1053, $c1054, $c1055, $c1056, $c1057, $c1058, $c1147];
const $c1145 = new Map([["kind", $c1146], ["condition", $c1048], ["provenance", $c1049], ["condition_source", $c1050], ["fit", $c1051], ["slip_includes", $c1052], ["slip_speed_factor", $c1053], ["temperature_factor", $c1054], ["notes", $c1055], ["tested_pressure", $c1056], ["tested_slip", $c1057], ["tested_slip_speed", $c1058], ["friction", $c1147]]);
const $c1041 = $made(tables$Table, $c883, [Constant, $c1144, $c1145]);
const $c1155 = ["elastic-plastic"];
const $c1154 = $made(Choice, $c920, [$c1155]);
const $c1152 = $made(Entry, $c898, ["kind", $c1154, true, "", "", "kind", ""]);
const $c1157 = $made(Limit, $c904, ["pressure_per_length", 0.0, 1000000000000000.0, true, false]);
const $c1156 = $made(Quantity, $c154, ["pressure_per_length", $c1157]);
const $c1153 = $made(Entry, $c898, ["stiffness", $c1156, true, "", "", "stiffness", ""]);
const $c1150 = [$c1152, $c1048, $c1049, $c1050, $c1051, $c1052, $c1053, $c1054, $c1055, $c1056, $c1057, $c1058, $c1153, $c1147];
const $c1151 = new Map([["kind", $c1152], ["condition", $c1048], ["provenance", $c1049], ["condition_source", $c1050], ["fit", $c1051], ["slip_includes", $c1052], ["slip_speed_factor", $c1053], ["temperature_factor", $c1054], ["notes", $c1055], ["tested_pressure", $c1056], ["tested_slip", $c1057], ["tested_slip_speed", $c1058], ["stiffness", $c1153], ["friction", $c1147]]);
const $c1042 = $made(tables$Table, $c883, [ElasticPlastic, $c1150, $c1151]);
const $c1165 = ["power"];
const $c1164 = $made(Choice, $c920, [$c1165]);
const $c1160 = $made(Entry, $c898, ["kind", $c1164, true, "", "", "kind", ""]);
const $c1161 = $made(Entry, $c898, ["friction", $c1125, true, "", "", "friction_coefficient", ""]);
const $c1162 = $made(Entry, $c898, ["reference_pressure", $c1110, true, "", "", "reference_pressure", ""]);
const $c1163 = $made(Entry, $c898, ["exponent", $c1023, true, "", "", "exponent", ""]);
const $c1158 = [$c1160, $c1048, $c1049, $c1050, $c1051, $c1052, $c1053, $c1054, $c1055, $c1056, $c1057, $c1058, $c1161, $c1162, $c1163];
const $c1159 = new Map([["kind", $c1160], ["condition", $c1048], ["provenance", $c1049], ["condition_source", $c1050], ["fit", $c1051], ["slip_includes", $c1052], ["slip_speed_factor", $c1053], ["temperature_factor", $c1054], ["notes", $c1055], ["tested_pressure", $c1056], ["tested_slip", $c1057], ["tested_slip_speed", $c1058], ["friction", $c1161], ["reference_pressure", $c1162], ["exponent", $c1163]]);
const $c1043 = $made(tables$Table, $c883, [PressurePower, $c1158, $c1159]);
const $c1172 = ["table"];
const $c1171 = $made(Choice, $c920, [$c1172]);
const $c1168 = $made(Entry, $c898, ["kind", $c1171, true, "", "", "kind", ""]);
const $c1175 = $made(Limit, $c904, ["length", 0.0, 1.0, false, false]);
const $c1174 = $made(Quantity, $c154, ["length", $c1175]);
const $c1173 = $made(Rows, $c936, [$c1174, 2, 1000]);
const $c1169 = $made(Entry, $c898, ["slip", $c1173, true, "", "slip = [\"0 mm\", \"2 mm\", \"10 mm\"]", "slip", ""]);
const $c1180 = $made(Entry, $c898, ["pressure", $c1110, true, "", "", "pressure", ""]);
const $c1184 = $made(Limit, $c904, ["number", 0.0, 5.0, false, false]);
const $c1183 = $made(Quantity, $c154, ["number", $c1184]);
const $c1182 = $made(Rows, $c936, [$c1183, 2, 1000]);
const $c1181 = $made(Entry, $c898, ["friction", $c1182, true, "", "", "values", ""]);
const $c1178 = [$c1180, $c1181];
const $c1179 = new Map([["pressure", $c1180], ["friction", $c1181]]);
const $c1177 = $made(tables$Table, $c883, [null, $c1178, $c1179]);
const $c1176 = $made(Rows, $c936, [$c1177, 1, 200]);
const $c1170 = $made(Entry, $c898, ["rows", $c1176, true, "", "rows = [{ pressure = \"100 kPa\", friction = [0.0, 0.4, 0.5] }], a friction for each slip", "rows", ""]);
const $c1166 = [$c1168, $c1048, $c1049, $c1050, $c1051, $c1052, $c1053, $c1054, $c1055, $c1169, $c1170];
const $c1167 = new Map([["kind", $c1168], ["condition", $c1048], ["provenance", $c1049], ["condition_source", $c1050], ["fit", $c1051], ["slip_includes", $c1052], ["slip_speed_factor", $c1053], ["temperature_factor", $c1054], ["notes", $c1055], ["slip", $c1169], ["rows", $c1170]]);
const $c1044 = $made(tables$Table, $c883, [MeasuredTable, $c1166, $c1167]);
const $c1039 = new Map([["integral-log", $c1040], ["constant", $c1041], ["elastic-plastic", $c1042], ["power", $c1043], ["table", $c1044]]);
const $c95 = $made(Variant, $c1038, ["kind", $c1039]);
const $c1037 = $made(OneOrMore, $c906, [$c95, 50]);
const $c979 = $made(Entry, $c898, ["law", $c1037, false, "", "", "law", ""]);
const $c980 = $made(Entry, $c898, ["notes", $c1089, false, "", "", "notes", ""]);
const $c959 = [$c961, $c962, $c963, $c964, $c965, $c966, $c967, $c968, $c969, $c970, $c971, $c972, $c973, $c974, $c975, $c976, $c977, $c978, $c979, $c147, $c148, $c980];
const $c960 = new Map([["preset", $c961], ["name", $c962], ["title", $c963], ["description", $c964], ["surface", $c965], ["thickness", $c966], ["elastic_modulus", $c967], ["shear_modulus", $c968], ["compression_modulus", $c969], ["block", $c970], ["wear_coefficient", $c971], ["belt_energy_share", $c972], ["bond_strength", $c973], ["fatigue_limit", $c974], ["cost", $c975], ["slip_speed", $c976], ["temperature", $c977], ["condition_factor", $c978], ["law", $c979], ["provenance", $c147], ["sources", $c148], ["notes", $c980]]);
const $c958 = $made(tables$Table, $c883, [Lagging, $c959, $c960]);
const $c214 = $made(TextOr, $c907, [$c216, $c958]);
const $c194 = $made(Entry, $c898, ["lagging", $c214, true, "", "lagging = \"diamond-rubber\"", "lagging", ""]);
const $c195 = $made(Entry, $c898, ["condition", $c217, false, "", "", "condition", ""]);
const $c220 = $made(Limit, $c904, ["force", 0.1, 1000000000.0, false, false]);
const $c219 = $made(Quantity, $c154, ["force", $c220]);
const $c196 = $made(Entry, $c898, ["entry_tension", $c219, false, "", "", "entry_tension", ""]);
const $c197 = $made(Entry, $c898, ["exit_tension", $c219, false, "", "", "exit_tension", ""]);
const $c221 = $made(Quantity, $c154, ["force", null]);
const $c198 = $made(Entry, $c898, ["effective_tension", $c221, false, "", "", "effective_tension", ""]);
const $c222 = $made(Quantity, $c154, ["torque", null]);
const $c199 = $made(Entry, $c898, ["torque", $c222, false, "", "", "torque", ""]);
const $c223 = $made(Quantity, $c154, ["power", null]);
const $c200 = $made(Entry, $c898, ["power", $c223, false, "", "", "power", ""]);
const $c226 = $made(Limit, $c904, ["length", -1.0, 1.0, false, false]);
const $c225 = $made(Quantity, $c154, ["length", $c226]);
const $c224 = $made(WordOr, $c934, ["formula", $c225, null]);
const $c201 = $made(Entry, $c898, ["overrun", $c224, false, "", "", "overrun", ""]);
const $c227 = $made(Flag, [], []);
const $c202 = $made(Entry, $c898, ["recovery", $c227, false, "", "", "recovery", ""]);
const $c229 = $made(Limit, $c904, ["length", 0.0, 1.0, true, false]);
const $c228 = $made(Quantity, $c154, ["length", $c229]);
const $c203 = $made(Entry, $c898, ["creep_limit", $c228, false, "", "", "creep_limit", ""]);
const $c869 = ["pulley", "carry"];
const $c230 = $made(Choice, $c920, [$c869]);
const $c204 = $made(Entry, $c898, ["side", $c230, false, "", "", "side", ""]);
const $c232 = $made(Limit, $c904, ["mass", 0.0, 1000000.0, true, false]);
const $c231 = $made(Quantity, $c154, ["mass", $c232]);
const $c205 = $made(Entry, $c898, ["mass", $c231, false, "", "", "mass", ""]);
const $c1601 = ["dimension", "diameters", "rows", "within"];
const $c1202 = ["kinds"];
const $c1204 = $made(Quantity, $c154, ["length", null]);
const $c1205 = $made(Quantity, $c154, ["length", null]);
const $c1203 = [$c1204, $c1205];
const $c1201 = $made(_Pair, $c1202, [$c1203]);
const $c1199 = $made(Rows, $c936, [$c1201, 0, 500]);
const $c1208 = $made(Entry, $c898, ["rows", $c1199, false, "", "", "rows", ""]);
const $c1213 = $made(Quantity, $c154, ["length", null]);
const $c1209 = $made(Entry, $c898, ["crown", $c1213, false, "", "", "crown", ""]);
const $c1215 = $made(Limit, $c904, ["number", 0.0, 100.0, false, false]);
const $c1214 = $made(Quantity, $c154, ["number", $c1215]);
const $c1210 = $made(Entry, $c898, ["factor", $c1214, false, "", "", "factor", ""]);
const $c1217 = $made(Limit, $c904, ["length", 0.0, Infinity, false, false]);
const $c1216 = $made(Quantity, $c154, ["length", $c1217]);
const $c1211 = $made(Entry, $c898, ["uncertainty", $c1216, false, "", "", "uncertainty", ""]);
const $c1219 = ["radius", "diameter"];
const $c1218 = $made(Choice, $c920, [$c1219]);
const $c1212 = $made(Entry, $c898, ["on", $c1218, false, "", "", "on", ""]);
const $c1206 = [$c1208, $c1209, $c1210, $c1211, $c1212];
const $c1207 = new Map([["rows", $c1208], ["crown", $c1209], ["factor", $c1210], ["uncertainty", $c1211], ["on", $c1212]]);
const $c1200 = $made(tables$Table, $c883, [null, $c1206, $c1207]);
const $c1198 = $made(TextOr, $c907, [$c1199, $c1200]);
const $c1196 = $made(Profile, $c1601, ["length", true, $c1199, $c1198]);
const $c1187 = $made(Entry, $c898, ["shell_profile", $c1196, false, "", "", "shell_profile", ""]);
const $c1226 = $made(Quantity, $c154, ["length", null]);
const $c1227 = $made(Quantity, $c154, ["length", null]);
const $c1225 = [$c1226, $c1227];
const $c1224 = $made(_Pair, $c1202, [$c1225]);
const $c1222 = $made(Rows, $c936, [$c1224, 0, 500]);
const $c1230 = $made(Entry, $c898, ["rows", $c1222, false, "", "", "rows", ""]);
const $c1235 = $made(Quantity, $c154, ["length", null]);
const $c1231 = $made(Entry, $c898, ["crown", $c1235, false, "", "", "crown", ""]);
const $c1237 = $made(Limit, $c904, ["number", 0.0, 100.0, false, false]);
const $c1236 = $made(Quantity, $c154, ["number", $c1237]);
const $c1232 = $made(Entry, $c898, ["factor", $c1236, false, "", "", "factor", ""]);
const $c1239 = $made(Limit, $c904, ["length", 0.0, Infinity, false, false]);
const $c1238 = $made(Quantity, $c154, ["length", $c1239]);
const $c1233 = $made(Entry, $c898, ["uncertainty", $c1238, false, "", "", "uncertainty", ""]);
const $c1240 = $made(Choice, $c920, [$c1219]);
const $c1234 = $made(Entry, $c898, ["on", $c1240, false, "", "", "on", ""]);
const $c1228 = [$c1230, $c1231, $c1232, $c1233, $c1234];
const $c1229 = new Map([["rows", $c1230], ["crown", $c1231], ["factor", $c1232], ["uncertainty", $c1233], ["on", $c1234]]);
const $c1223 = $made(tables$Table, $c883, [null, $c1228, $c1229]);
const $c1221 = $made(TextOr, $c907, [$c1222, $c1223]);
const $c1220 = $made(Profile, $c1601, ["length", true, $c1222, $c1221]);
const $c1188 = $made(Entry, $c898, ["worn_depth", $c1220, false, "", "", "worn_depth", ""]);
const $c1247 = $made(Quantity, $c154, ["length", null]);
const $c1248 = $made(Quantity, $c154, ["length", null]);
const $c1246 = [$c1247, $c1248];
const $c1245 = $made(_Pair, $c1202, [$c1246]);
const $c1243 = $made(Rows, $c936, [$c1245, 0, 500]);
const $c1251 = $made(Entry, $c898, ["rows", $c1243, false, "", "", "rows", ""]);
const $c1256 = $made(Quantity, $c154, ["length", null]);
const $c1252 = $made(Entry, $c898, ["crown", $c1256, false, "", "", "crown", ""]);
const $c1258 = $made(Limit, $c904, ["number", 0.0, 100.0, false, false]);
const $c1257 = $made(Quantity, $c154, ["number", $c1258]);
const $c1253 = $made(Entry, $c898, ["factor", $c1257, false, "", "", "factor", ""]);
const $c1260 = $made(Limit, $c904, ["length", 0.0, Infinity, false, false]);
const $c1259 = $made(Quantity, $c154, ["length", $c1260]);
const $c1254 = $made(Entry, $c898, ["uncertainty", $c1259, false, "", "", "uncertainty", ""]);
const $c1261 = $made(Choice, $c920, [$c1219]);
const $c1255 = $made(Entry, $c898, ["on", $c1261, false, "", "", "on", ""]);
const $c1249 = [$c1251, $c1252, $c1253, $c1254, $c1255];
const $c1250 = new Map([["rows", $c1251], ["crown", $c1252], ["factor", $c1253], ["uncertainty", $c1254], ["on", $c1255]]);
const $c1244 = $made(tables$Table, $c883, [null, $c1249, $c1250]);
const $c1242 = $made(TextOr, $c907, [$c1243, $c1244]);
const $c1241 = $made(Profile, $c1601, ["length", true, $c1243, $c1242]);
const $c1189 = $made(Entry, $c898, ["build_up", $c1241, false, "", "", "build_up", ""]);
const $c1263 = $made(Limit, $c904, ["number", -0.1, 0.1, false, false]);
const $c1262 = $made(Quantity, $c154, ["number", $c1263]);
const $c1190 = $made(Entry, $c898, ["misalignment", $c1262, false, "", "", "misalignment", ""]);
const $c1265 = $made(Limit, $c904, ["length", -0.1, 0.1, false, false]);
const $c1264 = $made(Quantity, $c154, ["length", $c1265]);
const $c1191 = $made(Entry, $c898, ["deflection", $c1264, false, "", "", "deflection", ""]);
const $c1272 = $made(Quantity, $c154, ["length", null]);
const $c1273 = $made(Quantity, $c154, ["force_per_width", null]);
const $c1271 = [$c1272, $c1273];
const $c1270 = $made(_Pair, $c1202, [$c1271]);
const $c1268 = $made(Rows, $c936, [$c1270, 0, 500]);
const $c1276 = $made(Entry, $c898, ["rows", $c1268, false, "", "", "rows", ""]);
const $c1280 = $made(Quantity, $c154, ["force_per_width", null]);
const $c1277 = $made(Entry, $c898, ["crown", $c1280, false, "", "", "crown", ""]);
const $c1282 = $made(Limit, $c904, ["number", 0.0, 100.0, false, false]);
const $c1281 = $made(Quantity, $c154, ["number", $c1282]);
const $c1278 = $made(Entry, $c898, ["factor", $c1281, false, "", "", "factor", ""]);
const $c1284 = $made(Limit, $c904, ["force_per_width", 0.0, Infinity, false, false]);
const $c1283 = $made(Quantity, $c154, ["force_per_width", $c1284]);
const $c1279 = $made(Entry, $c898, ["uncertainty", $c1283, false, "", "", "uncertainty", ""]);
const $c1274 = [$c1276, $c1277, $c1278, $c1279];
const $c1275 = new Map([["rows", $c1276], ["crown", $c1277], ["factor", $c1278], ["uncertainty", $c1279]]);
const $c1269 = $made(tables$Table, $c883, [null, $c1274, $c1275]);
const $c1267 = $made(TextOr, $c907, [$c1268, $c1269]);
const $c1266 = $made(Profile, $c1601, ["force_per_width", false, $c1268, $c1267]);
const $c1192 = $made(Entry, $c898, ["entry_profile", $c1266, false, "", "", "entry_profile", ""]);
const $c1294 = ["pulley"];
const $c1293 = $made(Choice, $c920, [$c1294]);
const $c1291 = $made(Entry, $c898, ["kind", $c1293, true, "", "", "kind", ""]);
const $c1296 = $made(Limit, $c904, ["length", 0.0, 100000.0, true, false]);
const $c1295 = $made(Quantity, $c154, ["length", $c1296]);
const $c1292 = $made(Entry, $c898, ["distance", $c1295, true, "", "", "distance", ""]);
const $c1289 = [$c1291, $c1292];
const $c1290 = new Map([["kind", $c1291], ["distance", $c1292]]);
const $c1287 = $made(tables$Table, $c883, [GrippingPulley, $c1289, $c1290]);
const $c1305 = ["transition"];
const $c1304 = $made(Choice, $c920, [$c1305]);
const $c1299 = $made(Entry, $c898, ["kind", $c1304, true, "", "", "kind", ""]);
const $c1307 = $made(Limit, $c904, ["length", 0.0, 1000.0, true, false]);
const $c1306 = $made(Quantity, $c154, ["length", $c1307]);
const $c1300 = $made(Entry, $c898, ["length", $c1306, true, "", "length = \"2.9 m\"", "length", ""]);
const $c1309 = $made(Limit, $c904, ["angle", 0.0, 1.5707963267948966, true, false]);
const $c1308 = $made(Quantity, $c154, ["angle", $c1309]);
const $c1301 = $made(Entry, $c898, ["trough_angle", $c1308, true, "", "trough_angle = \"35 deg\"", "trough_angle", ""]);
const $c1311 = $made(Limit, $c904, ["length", 0.0, 100.0, false, false]);
const $c1310 = $made(Quantity, $c154, ["length", $c1311]);
const $c1302 = $made(Entry, $c898, ["centre_roll", $c1310, true, "", "centre_roll = \"465 mm\"", "centre_roll", ""]);
const $c1313 = ["full", "half"];
const $c1312 = $made(Choice, $c920, [$c1313]);
const $c1303 = $made(Entry, $c898, ["depth", $c1312, false, "", "", "depth", ""]);
const $c1297 = [$c1299, $c1300, $c1301, $c1302, $c1303];
const $c1298 = new Map([["kind", $c1299], ["length", $c1300], ["trough_angle", $c1301], ["centre_roll", $c1302], ["depth", $c1303]]);
const $c1288 = $made(tables$Table, $c883, [Transition, $c1297, $c1298]);
const $c1286 = new Map([["pulley", $c1287], ["transition", $c1288]]);
const $c28 = $made(Variant, $c1038, ["kind", $c1286]);
const $c1285 = $made(WordOr, $c934, ["far", $c28, null]);
const $c1193 = $made(Entry, $c898, ["before", $c1285, false, "", "", "before", ""]);
const $c1321 = ["pulley"];
const $c1320 = $made(Choice, $c920, [$c1321]);
const $c1319 = $made(Entry, $c898, ["kind", $c1320, true, "", "", "kind", ""]);
const $c1317 = [$c1319, $c1292];
const $c1318 = new Map([["kind", $c1319], ["distance", $c1292]]);
const $c1316 = $made(tables$Table, $c883, [GrippingPulley, $c1317, $c1318]);
const $c1315 = new Map([["pulley", $c1316]]);
const $c29 = $made(Variant, $c1038, ["kind", $c1315]);
const $c1314 = $made(WordOr, $c934, ["far", $c29, null]);
const $c1194 = $made(Entry, $c898, ["after", $c1314, false, "", "", "after", ""]);
const $c1323 = ["least", "most"];
const $c1322 = $made(Count, $c1323, [4, 128]);
const $c1195 = $made(Entry, $c898, ["strips", $c1322, false, "", "", "strips", ""]);
const $c1185 = [$c1187, $c1188, $c1189, $c1190, $c1191, $c1192, $c1193, $c1194, $c1195];
const $c1186 = new Map([["shell_profile", $c1187], ["worn_depth", $c1188], ["build_up", $c1189], ["misalignment", $c1190], ["deflection", $c1191], ["entry_profile", $c1192], ["before", $c1193], ["after", $c1194], ["strips", $c1195]]);
const $c30 = $made(tables$Table, $c883, [Across, $c1185, $c1186]);
const $c206 = $made(Entry, $c898, ["across", $c30, false, "", "", "across", ""]);
const $c233 = $made(ByName, $c906, [$c2, 200]);
const $c207 = $made(Entry, $c898, ["sources", $c233, false, "", "", "sources", ""]);
const $c9 = [$c190, $c191, $c192, $c193, $c194, $c195, $c196, $c197, $c198, $c199, $c200, $c201, $c202, $c203, $c204, $c205, $c206, $c207];
const $c937 = new Map([["name", $c190], ["diameter", $c191], ["wrap_angle", $c192], ["belt_path", $c193], ["lagging", $c194], ["condition", $c195], ["entry_tension", $c196], ["exit_tension", $c197], ["effective_tension", $c198], ["torque", $c199], ["power", $c200], ["overrun", $c201], ["recovery", $c202], ["creep_limit", $c203], ["side", $c204], ["mass", $c205], ["across", $c206], ["sources", $c207]]);
const $c31 = $made(tables$Table, $c883, [Pulley, $c9, $c937]);
const $c935 = $made(Rows, $c936, [$c31, 1, 10]);
const $c892 = $made(Entry, $c898, ["pulley", $c935, true, "", "a [[pulley]] table for each pulley", "pulley", ""]);
const $c1324 = $made(ByName, $c906, [$c958, 200]);
const $c893 = $made(Entry, $c898, ["lagging", $c1324, false, "", "", "lagging", ""]);
const $c1335 = $made(Name, $c908, [60]);
const $c1329 = $made(Entry, $c898, ["name", $c1335, true, "", "name = \"start\"", "name", ""]);
const $c1336 = $made(Text, $c901, [1000, true]);
const $c1330 = $made(Entry, $c898, ["description", $c1336, false, "", "", "description", ""]);
const $c104 = ["running", "starting", "braking"];
const $c1337 = $made(Choice, $c920, [$c104]);
const $c1331 = $made(Entry, $c898, ["kind", $c1337, false, "", "", "kind", ""]);
const $c1332 = $made(Entry, $c898, ["condition", $c217, false, "", "", "condition", ""]);
const $c1340 = [$c196, $c197, $c198, $c199, $c200];
const $c1341 = new Map([["entry_tension", $c196], ["exit_tension", $c197], ["effective_tension", $c198], ["torque", $c199], ["power", $c200]]);
const $c1339 = $made(tables$Table, $c883, [null, $c1340, $c1341]);
const $c1338 = $made(ByName, $c906, [$c1339, 200]);
const $c1333 = $made(Entry, $c898, ["pulley", $c1338, false, "", "", "pulley", ""]);
const $c1342 = $made(Elsewhere, [], []);
const $c1334 = $made(Entry, $c898, ["train", $c1342, false, "", "", "train", ""]);
const $c1327 = [$c1329, $c1330, $c1331, $c1332, $c1333, $c1334];
const $c1328 = new Map([["name", $c1329], ["description", $c1330], ["kind", $c1331], ["condition", $c1332], ["pulley", $c1333], ["train", $c1334]]);
const $c1326 = $made(tables$Table, $c883, [null, $c1327, $c1328]);
const $c1325 = $made(Rows, $c936, [$c1326, 1, 1000]);
const $c894 = $made(Entry, $c898, ["load_case", $c1325, false, "", "", "load_case", ""]);
const $c683 = $made(Limit, $c904, ["length", 0.0, 100000.0, true, false]);
const $c1364 = $made(Quantity, $c154, ["length", $c683]);
const $c1345 = $made(Entry, $c898, ["length", $c1364, true, "", "length = \"600 m\"", "length", ""]);
const $c684 = $made(Limit, $c904, ["length", -5000.0, 5000.0, false, false]);
const $c1365 = $made(Quantity, $c154, ["length", $c684]);
const $c1346 = $made(Entry, $c898, ["lift", $c1365, false, "", "", "lift", ""]);
const $c685 = $made(Limit, $c904, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c1366 = $made(Quantity, $c154, ["mass_per_length", $c685]);
const $c1347 = $made(Entry, $c898, ["belt_mass", $c1366, true, "", "", "belt_mass", ""]);
const $c686 = $made(Limit, $c904, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c1367 = $made(Quantity, $c154, ["mass_per_length", $c686]);
const $c1348 = $made(Entry, $c898, ["carry_idler_mass", $c1367, true, "", "", "carry_idler_mass", ""]);
const $c687 = $made(Limit, $c904, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c1368 = $made(Quantity, $c154, ["mass_per_length", $c687]);
const $c1349 = $made(Entry, $c898, ["return_idler_mass", $c1368, true, "", "", "return_idler_mass", ""]);
const $c1369 = $made(Quantity, $c154, ["mass_per_length", $c685]);
const $c1350 = $made(Entry, $c898, ["material_mass", $c1369, false, "", "", "material_mass", ""]);
const $c688 = $made(Limit, $c904, ["mass_flow", 0.0, 100000.0, true, false]);
const $c1370 = $made(Quantity, $c154, ["mass_flow", $c688]);
const $c1351 = $made(Entry, $c898, ["capacity", $c1370, false, "", "", "capacity", ""]);
const $c689 = $made(Limit, $c904, ["number", 0.005, 0.1, false, false]);
const $c1371 = $made(Quantity, $c154, ["number", $c689]);
const $c1352 = $made(Entry, $c898, ["friction_factor", $c1371, false, "", "", "friction_factor", ""]);
const $c690 = $made(Limit, $c904, ["number", 1.0, 10.0, false, false]);
const $c1372 = $made(Quantity, $c154, ["number", $c690]);
const $c1353 = $made(Entry, $c898, ["length_coefficient", $c1372, false, "", "", "length_coefficient", ""]);
const $c691 = $made(Limit, $c904, ["force", 0.0, 100000000.0, false, false]);
const $c1373 = $made(Quantity, $c154, ["force", $c691]);
const $c1354 = $made(Entry, $c898, ["secondary_resistance", $c1373, false, "", "", "secondary_resistance", ""]);
const $c1374 = $made(Quantity, $c154, ["force", $c691]);
const $c1355 = $made(Entry, $c898, ["special_resistance", $c1374, false, "", "", "special_resistance", ""]);
const $c692 = $made(Limit, $c904, ["number", 0.0, 1.0, false, false]);
const $c1375 = $made(Quantity, $c154, ["number", $c692]);
const $c1356 = $made(Entry, $c898, ["return_share", $c1375, false, "", "", "return_share", ""]);
const $c693 = $made(Limit, $c904, ["number", 1.0, 5.0, false, false]);
const $c1376 = $made(Quantity, $c154, ["number", $c693]);
const $c1357 = $made(Entry, $c898, ["start_factor", $c1376, false, "", "", "start_factor", ""]);
const $c694 = $made(Limit, $c904, ["time", 0.0, 3600.0, true, false]);
const $c1377 = $made(Quantity, $c154, ["time", $c694]);
const $c1358 = $made(Entry, $c898, ["start_time", $c1377, false, "", "", "start_time", ""]);
const $c1378 = $made(Quantity, $c154, ["time", $c694]);
const $c1359 = $made(Entry, $c898, ["stop_time", $c1378, false, "", "", "stop_time", ""]);
const $c695 = $made(Limit, $c904, ["force", 0.0, 100000000.0, true, false]);
const $c1379 = $made(Quantity, $c154, ["force", $c695]);
const $c1360 = $made(Entry, $c898, ["take_up_tension", $c1379, false, "", "", "take_up_tension", ""]);
const $c696 = $made(Limit, $c904, ["mass", 0.0, 10000000.0, true, false]);
const $c1380 = $made(Quantity, $c154, ["mass", $c696]);
const $c1361 = $made(Entry, $c898, ["counterweight", $c1380, false, "", "", "counterweight", ""]);
const $c697 = $made(Limit, $c904, ["length", 0.0, 100000.0, false, false]);
const $c1381 = $made(Quantity, $c154, ["length", $c697]);
const $c1362 = $made(Entry, $c898, ["take_up_distance", $c1381, false, "", "", "take_up_distance", ""]);
const $c870 = ["head", "tail"];
const $c1382 = $made(Choice, $c920, [$c870]);
const $c1363 = $made(Entry, $c898, ["drive_at", $c1382, false, "", "", "drive_at", ""]);
const $c1343 = [$c1345, $c1346, $c1347, $c1348, $c1349, $c1350, $c1351, $c1352, $c1353, $c1354, $c1355, $c1356, $c1357, $c1358, $c1359, $c1360, $c1361, $c1362, $c1363];
const $c1344 = new Map([["length", $c1345], ["lift", $c1346], ["belt_mass", $c1347], ["carry_idler_mass", $c1348], ["return_idler_mass", $c1349], ["material_mass", $c1350], ["capacity", $c1351], ["friction_factor", $c1352], ["length_coefficient", $c1353], ["secondary_resistance", $c1354], ["special_resistance", $c1355], ["return_share", $c1356], ["start_factor", $c1357], ["start_time", $c1358], ["stop_time", $c1359], ["take_up_tension", $c1360], ["counterweight", $c1361], ["take_up_distance", $c1362], ["drive_at", $c1363]]);
const $c35 = $made(tables$Table, $c883, [Conveyor, $c1343, $c1344]);
const $c895 = $made(Entry, $c898, ["conveyor", $c35, false, "", "", "conveyor", ""]);
const $c863 = ["gravity", "winch", "fixed"];
const $c1388 = $made(Choice, $c920, [$c863]);
const $c1385 = $made(Entry, $c898, ["kind", $c1388, false, "", "", "kind", ""]);
const $c854 = $made(Limit, $c904, ["number", 0.01, 100.0, false, false]);
const $c1389 = $made(Quantity, $c154, ["number", $c854]);
const $c1386 = $made(Entry, $c898, ["sheave_ratio", $c1389, false, "", "", "sheave_ratio", ""]);
const $c1390 = $made(Name, $c908, [60]);
const $c1387 = $made(Entry, $c898, ["after", $c1390, false, "", "", "after", ""]);
const $c1383 = [$c1385, $c1386, $c1387];
const $c1384 = new Map([["kind", $c1385], ["sheave_ratio", $c1386], ["after", $c1387]]);
const $c563 = $made(tables$Table, $c883, [TakeUp, $c1383, $c1384]);
const $c559 = $made(Entry, $c898, ["take_up", $c563, false, "", "", "take_up", ""]);
const $c864 = ["CEMA", "DIN 22101", "own", "none"];
const $c1398 = $made(Choice, $c920, [$c864]);
const $c1393 = $made(Entry, $c898, ["name", $c1398, false, "", "", "name", ""]);
const $c865 = ["dry", "wet", "wet and dirty"];
const $c1399 = $made(Choice, $c920, [$c865]);
const $c1394 = $made(Entry, $c898, ["condition", $c1399, false, "", "", "condition", ""]);
const $c855 = $made(Limit, $c904, ["number", 0.01, 2.0, false, false]);
const $c1400 = $made(Quantity, $c154, ["number", $c855]);
const $c1395 = $made(Entry, $c898, ["friction", $c1400, false, "", "", "friction", ""]);
const $c856 = $made(Limit, $c904, ["number", 1.0, 10.0, false, false]);
const $c1401 = $made(Quantity, $c154, ["number", $c856]);
const $c1396 = $made(Entry, $c898, ["start_factor", $c1401, false, "", "", "start_factor", ""]);
const $c1402 = $made(Flag, [], []);
const $c1397 = $made(Entry, $c898, ["binding", $c1402, false, "", "", "binding", ""]);
const $c1391 = [$c1393, $c1394, $c1395, $c1396, $c1397];
const $c1392 = new Map([["name", $c1393], ["condition", $c1394], ["friction", $c1395], ["start_factor", $c1396], ["binding", $c1397]]);
const $c564 = $made(tables$Table, $c883, [DesignStandard, $c1391, $c1392]);
const $c560 = $made(Entry, $c898, ["design_standard", $c564, false, "", "", "standard", ""]);
const $c1409 = $made(Quantity, $c154, ["number", $c856]);
const $c1405 = $made(Entry, $c898, ["running", $c1409, false, "", "", "running", ""]);
const $c1410 = $made(Quantity, $c154, ["number", $c856]);
const $c1406 = $made(Entry, $c898, ["starting", $c1410, false, "", "", "starting", ""]);
const $c1411 = $made(Quantity, $c154, ["number", $c856]);
const $c1407 = $made(Entry, $c898, ["braking", $c1411, false, "", "", "braking", ""]);
const $c1412 = $made(Text, $c901, [500, false]);
const $c1408 = $made(Entry, $c898, ["source", $c1412, false, "", "", "source", ""]);
const $c1403 = [$c1405, $c1406, $c1407, $c1408];
const $c1404 = new Map([["running", $c1405], ["starting", $c1406], ["braking", $c1407], ["source", $c1408]]);
const $c565 = $made(tables$Table, $c883, [SafetyFactors, $c1403, $c1404]);
const $c561 = $made(Entry, $c898, ["safety_factor", $c565, false, "", "", "safety", ""]);
const $c1419 = $made(Limit, $c904, ["length", 0.0, 100.0, true, false]);
const $c1418 = $made(Quantity, $c154, ["length", $c1419]);
const $c1415 = $made(Entry, $c898, ["idler_spacing", $c1418, true, "", "idler_spacing = \"3 m\"", "spacing", ""]);
const $c1421 = $made(Limit, $c904, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c1420 = $made(Quantity, $c154, ["mass_per_length", $c1421]);
const $c1416 = $made(Entry, $c898, ["line_mass", $c1420, true, "", "line_mass = \"22 kg/m\"", "line_mass", ""]);
const $c1423 = $made(Limit, $c904, ["number", 0.0, 0.1, true, false]);
const $c1422 = $made(Quantity, $c154, ["number", $c1423]);
const $c1417 = $made(Entry, $c898, ["share", $c1422, false, "", "", "share", ""]);
const $c1413 = [$c1415, $c1416, $c1417];
const $c1414 = new Map([["idler_spacing", $c1415], ["line_mass", $c1416], ["share", $c1417]]);
const $c566 = $made(tables$Table, $c883, [Sag, $c1413, $c1414]);
const $c562 = $made(Entry, $c898, ["sag", $c566, false, "", "", "sag", ""]);
const $c1424 = $made(Elsewhere, [], []);
const $c896 = $made(Entry, $c898, ["train", $c1424, false, "", "", "train", ""]);
const $c1425 = $made(Elsewhere, [], []);
const $c897 = $made(Entry, $c898, ["motion", $c1425, false, "", "", "motion", ""]);
const $c884 = [$c886, $c887, $c888, $c889, $c890, $c891, $c892, $c893, $c894, $c895, $c559, $c560, $c561, $c562, $c896, $c897];
const $c885 = new Map([["format", $c886], ["title", $c887], ["description", $c888], ["creep_limit", $c889], ["condition", $c890], ["belt", $c891], ["pulley", $c892], ["lagging", $c893], ["load_case", $c894], ["conveyor", $c895], ["take_up", $c559], ["design_standard", $c560], ["safety_factor", $c561], ["sag", $c562], ["train", $c896], ["motion", $c897]]);
const $c0 = $made(tables$Table, $c883, [Drive, $c884, $c885]);
const $c3 = ["name", "kind", "modulus", "rating", "least_pulley_diameter", "carcass"];
const $c4 = new Map([["width", $c155], ["modulus", $c160], ["rating", $c162], ["strength", $c164], ["speed", $c166], ["momentary_factor", $c168], ["least_pulley_diameter", $c170], ["largest_wrap_pressure", $c172], ["in_plane_shear_stiffness", $c174], ["pulley_cover", $c176], ["carry_cover", $c178], ["carcass", $c180], ["thickness", $c182], ["cover_shear_modulus", $c185], ["mass", $c187]]);
const $c6 = ["pulley_cover", "carry_cover", "carcass"];
const $c7 = $made(_Nothing, [], []);
const $c10 = ["x", "y", "diameter", "turn"];
const $c259 = [10000, "m"];
const $c258 = [$c259];
const $c236 = ["mm", $c258];
const $c237 = ["kN", []];
const $c238 = ["kN/m", []];
const $c261 = [10000, "MPa"];
const $c260 = [$c261];
const $c239 = ["kPa", $c260];
const $c240 = ["kPa/mm", []];
const $c241 = ["m/s", []];
const $c242 = ["deg", []];
const $c243 = ["kW", []];
const $c244 = ["kN m", []];
const $c245 = ["m2", []];
const $c246 = ["s", []];
const $c247 = ["degC", []];
const $c248 = ["1/mm", []];
const $c249 = ["mm3/J", []];
const $c250 = ["J/m2", []];
const $c263 = [10000, "kW/m2"];
const $c262 = [$c263];
const $c251 = ["W/m2", $c262];
const $c252 = ["rpm", []];
const $c253 = ["kg", []];
const $c254 = ["kg/m", []];
const $c255 = ["t/h", []];
const $c256 = ["kg m2", []];
const $c257 = ["", []];
const $c234 = new Map([["length", $c236], ["force", $c237], ["force_per_width", $c238], ["spring_rate", $c238], ["pressure", $c239], ["pressure_per_length", $c240], ["speed", $c241], ["angle", $c242], ["power", $c243], ["torque", $c244], ["area", $c245], ["time", $c246], ["temperature", $c247], ["per_length", $c248], ["wear_coefficient", $c249], ["energy_per_area", $c250], ["power_per_area", $c251], ["rotation_speed", $c252], ["mass", $c253], ["mass_per_length", $c254], ["mass_flow", $c255], ["moment_of_inertia", $c256], ["number", $c257]]);
const $c284 = [400, "ft"];
const $c283 = [$c284];
const $c264 = ["in", $c283];
const $c265 = ["lbf", []];
const $c266 = ["PIW", []];
const $c267 = ["lbf/in", []];
const $c286 = [10000, "ksi"];
const $c285 = [$c286];
const $c268 = ["psi", $c285];
const $c269 = ["psi/in", []];
const $c270 = ["fpm", []];
const $c271 = ["hp", []];
const $c272 = ["lbf ft", []];
const $c273 = ["in2", []];
const $c274 = ["degF", []];
const $c275 = ["1/in", []];
const $c276 = ["in3/(ft lbf)", []];
const $c277 = ["ft lbf/ft2", []];
const $c278 = ["hp/ft2", []];
const $c279 = ["lbm", []];
const $c280 = ["lbm/ft", []];
const $c281 = ["lbm/h", []];
const $c282 = ["lbm ft2", []];
const $c235 = new Map([["length", $c264], ["force", $c265], ["force_per_width", $c266], ["spring_rate", $c267], ["pressure", $c268], ["pressure_per_length", $c269], ["speed", $c270], ["angle", $c242], ["power", $c271], ["torque", $c272], ["area", $c273], ["time", $c246], ["temperature", $c274], ["per_length", $c275], ["wear_coefficient", $c276], ["energy_per_area", $c277], ["power_per_area", $c278], ["rotation_speed", $c252], ["mass", $c279], ["mass_per_length", $c280], ["mass_flow", $c281], ["moment_of_inertia", $c282], ["number", $c257]]);
const $c11 = new Map([["si", $c234], ["us", $c235]]);
const $c287 = new DimensionText("m", "a length", "1200 mm");
const $c288 = new DimensionText("N", "a force", "150 kN");
const $c289 = new DimensionText("N/m", "a force per width", "12960 kN/m");
const $c290 = new DimensionText("N/m", "a spring rate", "12000 kN/m");
const $c291 = new DimensionText("Pa", "a pressure", "200 kPa");
const $c292 = new DimensionText("Pa/m", "a pressure per length", "190 kPa/mm");
const $c293 = new DimensionText("m/s", "a speed", "3 m/s");
const $c294 = new DimensionText("rad", "an angle", "180 deg");
const $c295 = new DimensionText("W", "a power", "250 kW");
const $c296 = new DimensionText("N m", "a torque", "40 kN m");
const $c297 = new DimensionText("m2", "an area", "2500 mm2");
const $c298 = new DimensionText("s", "a time", "10 s");
const $c299 = new DimensionText("K", "a temperature", "20 degC");
const $c300 = new DimensionText("1/m", "a value per length", "-0.016 1/mm");
const $c301 = new DimensionText("m3/J", "a wear volume per energy", "0.05 mm3/J");
const $c302 = new DimensionText("J/m2", "an energy per area", "800 J/m2");
const $c303 = new DimensionText("W/m2", "a power per area", "1500 W/m2");
const $c304 = new DimensionText("rad/s", "a rotation speed", "71.6 rpm");
const $c305 = new DimensionText("kg", "a mass", "500 kg");
const $c306 = new DimensionText("kg/m", "a mass per length", "22 kg/m");
const $c307 = new DimensionText("kg/s", "a mass flow", "1500 t/h");
const $c308 = new DimensionText("kg m2", "a moment of inertia", "2200 kg m2");
const $c309 = new DimensionText("", "a plain number", "0.35");
const $c12 = new Map([["length", $c287], ["force", $c288], ["force_per_width", $c289], ["spring_rate", $c290], ["pressure", $c291], ["pressure_per_length", $c292], ["speed", $c293], ["angle", $c294], ["power", $c295], ["torque", $c296], ["area", $c297], ["time", $c298], ["temperature", $c299], ["per_length", $c300], ["wear_coefficient", $c301], ["energy_per_area", $c302], ["power_per_area", $c303], ["rotation_speed", $c304], ["mass", $c305], ["mass_per_length", $c306], ["mass_flow", $c307], ["moment_of_inertia", $c308], ["number", $c309]]);
const $c13 = $re("[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?", "");
const $c14 = $re("[0-9.,'’_´`\\s+\\-−/:;]*(?:(?<=[0-9])[eE][+-]?[0-9]+)?", "");
const $c15 = $re("[+-]?\\s*(?:nan|inf|infinity|∞)\\b", "i");
const $c16 = $re("[eE][+-]?([0-9]+)$", "");
const $c17 = $re("(?<=[0-9])[\\s'’_´`]+(?=[0-9])", "");
const $c18 = $re("[,.]", "");
const $c19 = $re("1\\s*/\\s*[A-Za-z(]", "");
const $c20 = $re("[0-9.,'’_´`+\\-−:;]|/\\s*[0-9]", "");
const $c21 = ["kg", "m", "s", "K", "rad"];
const $c372 = ["meter", "meters", "metre", "metres"];
const $c373 = $Decimal.of("1");
const $c374 = $Decimal.of("0");
const $c310 = new Definition($c372, $c373, "m", $c374);
const $c375 = ["km"];
const $c376 = $Decimal.of("1000");
const $c377 = $Decimal.of("0");
const $c311 = new Definition($c375, $c376, "m", $c377);
const $c378 = ["dm"];
const $c379 = $Decimal.of("0.1");
const $c380 = $Decimal.of("0");
const $c312 = new Definition($c378, $c379, "m", $c380);
const $c381 = ["cm"];
const $c382 = $Decimal.of("0.01");
const $c383 = $Decimal.of("0");
const $c313 = new Definition($c381, $c382, "m", $c383);
const $c384 = ["mm"];
const $c385 = $Decimal.of("0.001");
const $c386 = $Decimal.of("0");
const $c314 = new Definition($c384, $c385, "m", $c386);
const $c387 = ["um", "micron", "microns"];
const $c388 = $Decimal.of("0.000001");
const $c389 = $Decimal.of("0");
const $c315 = new Definition($c387, $c388, "m", $c389);
const $c390 = ["in", "inch", "inches", "\""];
const $c391 = $Decimal.of("0.0254");
const $c392 = $Decimal.of("0");
const $c316 = new Definition($c390, $c391, "m", $c392);
const $c393 = ["ft", "foot", "feet"];
const $c394 = $Decimal.of("12");
const $c395 = $Decimal.of("0");
const $c317 = new Definition($c393, $c394, "in", $c395);
const $c396 = ["yd"];
const $c397 = $Decimal.of("3");
const $c398 = $Decimal.of("0");
const $c318 = new Definition($c396, $c397, "ft", $c398);
const $c399 = ["mi", "mile", "miles"];
const $c400 = $Decimal.of("5280");
const $c401 = $Decimal.of("0");
const $c319 = new Definition($c399, $c400, "ft", $c401);
const $c402 = ["thou"];
const $c403 = $Decimal.of("0.001");
const $c404 = $Decimal.of("0");
const $c320 = new Definition($c402, $c403, "in", $c404);
const $c405 = ["g"];
const $c406 = $Decimal.of("0.001");
const $c407 = $Decimal.of("0");
const $c321 = new Definition($c405, $c406, "kg", $c407);
const $c408 = ["t", "tonne", "tonnes"];
const $c409 = $Decimal.of("1000");
const $c410 = $Decimal.of("0");
const $c322 = new Definition($c408, $c409, "kg", $c410);
const $c411 = ["lbm"];
const $c412 = $Decimal.of("0.45359237");
const $c413 = $Decimal.of("0");
const $c323 = new Definition($c411, $c412, "kg", $c413);
const $c414 = ["sec", "second", "seconds"];
const $c415 = $Decimal.of("1");
const $c416 = $Decimal.of("0");
const $c324 = new Definition($c414, $c415, "s", $c416);
const $c417 = ["ms"];
const $c418 = $Decimal.of("0.001");
const $c419 = $Decimal.of("0");
const $c325 = new Definition($c417, $c418, "s", $c419);
const $c420 = ["min", "minute", "minutes"];
const $c421 = $Decimal.of("60");
const $c422 = $Decimal.of("0");
const $c326 = new Definition($c420, $c421, "s", $c422);
const $c423 = ["h", "hr", "hour", "hours"];
const $c424 = $Decimal.of("60");
const $c425 = $Decimal.of("0");
const $c327 = new Definition($c423, $c424, "min", $c425);
const $c426 = ["d", "day", "days"];
const $c427 = $Decimal.of("24");
const $c428 = $Decimal.of("0");
const $c328 = new Definition($c426, $c427, "h", $c428);
const $c429 = ["N", "newton", "newtons"];
const $c430 = $Decimal.of("1");
const $c431 = $Decimal.of("0");
const $c329 = new Definition($c429, $c430, "kg m/s2", $c431);
const $c432 = ["mN"];
const $c433 = $Decimal.of("0.001");
const $c434 = $Decimal.of("0");
const $c330 = new Definition($c432, $c433, "N", $c434);
const $c435 = ["daN"];
const $c436 = $Decimal.of("10");
const $c437 = $Decimal.of("0");
const $c331 = new Definition($c435, $c436, "N", $c437);
const $c438 = ["kN"];
const $c439 = $Decimal.of("1000");
const $c440 = $Decimal.of("0");
const $c332 = new Definition($c438, $c439, "N", $c440);
const $c441 = ["MN"];
const $c442 = $Decimal.of("1E+6");
const $c443 = $Decimal.of("0");
const $c333 = new Definition($c441, $c442, "N", $c443);
const $c444 = ["kgf", "kp"];
const $c445 = $Decimal.of("9.80665");
const $c446 = $Decimal.of("0");
const $c334 = new Definition($c444, $c445, "N", $c446);
const $c447 = ["gf"];
const $c448 = $Decimal.of("0.001");
const $c449 = $Decimal.of("0");
const $c335 = new Definition($c447, $c448, "kgf", $c449);
const $c450 = ["tf"];
const $c451 = $Decimal.of("1000");
const $c452 = $Decimal.of("0");
const $c336 = new Definition($c450, $c451, "kgf", $c452);
const $c453 = ["lbf", "lb", "lbs"];
const $c454 = $Decimal.of("4.4482216152605");
const $c455 = $Decimal.of("0");
const $c337 = new Definition($c453, $c454, "N", $c455);
const $c456 = ["klbf", "kip", "kips"];
const $c457 = $Decimal.of("1000");
const $c458 = $Decimal.of("0");
const $c338 = new Definition($c456, $c457, "lbf", $c458);
const $c459 = ["PIW", "piw", "PLI", "pli"];
const $c460 = $Decimal.of("1");
const $c461 = $Decimal.of("0");
const $c339 = new Definition($c459, $c460, "lbf/in", $c461);
const $c462 = ["Pa"];
const $c463 = $Decimal.of("1");
const $c464 = $Decimal.of("0");
const $c340 = new Definition($c462, $c463, "N/m2", $c464);
const $c465 = ["hPa"];
const $c466 = $Decimal.of("100");
const $c467 = $Decimal.of("0");
const $c341 = new Definition($c465, $c466, "Pa", $c467);
const $c468 = ["kPa"];
const $c469 = $Decimal.of("1000");
const $c470 = $Decimal.of("0");
const $c342 = new Definition($c468, $c469, "Pa", $c470);
const $c471 = ["MPa"];
const $c472 = $Decimal.of("1E+6");
const $c473 = $Decimal.of("0");
const $c343 = new Definition($c471, $c472, "Pa", $c473);
const $c474 = ["GPa"];
const $c475 = $Decimal.of("1E+9");
const $c476 = $Decimal.of("0");
const $c344 = new Definition($c474, $c475, "Pa", $c476);
const $c477 = ["bar"];
const $c478 = $Decimal.of("1E+5");
const $c479 = $Decimal.of("0");
const $c345 = new Definition($c477, $c478, "Pa", $c479);
const $c480 = ["mbar"];
const $c481 = $Decimal.of("100");
const $c482 = $Decimal.of("0");
const $c346 = new Definition($c480, $c481, "Pa", $c482);
const $c483 = ["psi", "PSI"];
const $c484 = $Decimal.of("1");
const $c485 = $Decimal.of("0");
const $c347 = new Definition($c483, $c484, "lbf/in2", $c485);
const $c486 = ["ksi"];
const $c487 = $Decimal.of("1000");
const $c488 = $Decimal.of("0");
const $c348 = new Definition($c486, $c487, "psi", $c488);
const $c489 = ["J", "joule"];
const $c490 = $Decimal.of("1");
const $c491 = $Decimal.of("0");
const $c349 = new Definition($c489, $c490, "N m", $c491);
const $c492 = ["mJ"];
const $c493 = $Decimal.of("0.001");
const $c494 = $Decimal.of("0");
const $c350 = new Definition($c492, $c493, "J", $c494);
const $c495 = ["kJ"];
const $c496 = $Decimal.of("1000");
const $c497 = $Decimal.of("0");
const $c351 = new Definition($c495, $c496, "J", $c497);
const $c498 = ["MJ"];
const $c499 = $Decimal.of("1E+6");
const $c500 = $Decimal.of("0");
const $c352 = new Definition($c498, $c499, "J", $c500);
const $c501 = ["Nm"];
const $c502 = $Decimal.of("1");
const $c503 = $Decimal.of("0");
const $c353 = new Definition($c501, $c502, "N m", $c503);
const $c504 = ["kNm"];
const $c505 = $Decimal.of("1000");
const $c506 = $Decimal.of("0");
const $c354 = new Definition($c504, $c505, "N m", $c506);
const $c507 = ["MNm"];
const $c508 = $Decimal.of("1E+6");
const $c509 = $Decimal.of("0");
const $c355 = new Definition($c507, $c508, "N m", $c509);
const $c510 = ["W", "watt", "watts"];
const $c511 = $Decimal.of("1");
const $c512 = $Decimal.of("0");
const $c356 = new Definition($c510, $c511, "J/s", $c512);
const $c513 = ["kW"];
const $c514 = $Decimal.of("1000");
const $c515 = $Decimal.of("0");
const $c357 = new Definition($c513, $c514, "W", $c515);
const $c516 = ["MW"];
const $c517 = $Decimal.of("1E+6");
const $c518 = $Decimal.of("0");
const $c358 = new Definition($c516, $c517, "W", $c518);
const $c519 = ["hp", "HP", "bhp", "BHP"];
const $c520 = $Decimal.of("550");
const $c521 = $Decimal.of("0");
const $c359 = new Definition($c519, $c520, "ft lbf/s", $c521);
const $c522 = ["PS", "cv", "CV", "hp(metric)"];
const $c523 = $Decimal.of("75");
const $c524 = $Decimal.of("0");
const $c360 = new Definition($c522, $c523, "kgf m/s", $c524);
const $c525 = ["fpm", "FPM"];
const $c526 = $Decimal.of("1");
const $c527 = $Decimal.of("0");
const $c361 = new Definition($c525, $c526, "ft/min", $c527);
const $c528 = ["fps"];
const $c529 = $Decimal.of("1");
const $c530 = $Decimal.of("0");
const $c362 = new Definition($c528, $c529, "ft/s", $c530);
const $c531 = ["kph", "kmh"];
const $c532 = $Decimal.of("1");
const $c533 = $Decimal.of("0");
const $c363 = new Definition($c531, $c532, "km/h", $c533);
const $c534 = ["mph"];
const $c535 = $Decimal.of("1");
const $c536 = $Decimal.of("0");
const $c364 = new Definition($c534, $c535, "mi/h", $c536);
const $c537 = ["mrad"];
const $c538 = $Decimal.of("0.001");
const $c539 = $Decimal.of("0");
const $c365 = new Definition($c537, $c538, "rad", $c539);
const $c540 = ["deg", "degree", "degrees", "°"];
const $c541 = $Decimal.of("0.01745329251994329576923690768");
const $c542 = $Decimal.of("0");
const $c366 = new Definition($c540, $c541, "rad", $c542);
const $c543 = ["rev", "turn", "turns"];
const $c544 = $Decimal.of("360");
const $c545 = $Decimal.of("0");
const $c367 = new Definition($c543, $c544, "deg", $c545);
const $c546 = ["rpm", "RPM"];
const $c547 = $Decimal.of("1");
const $c548 = $Decimal.of("0");
const $c368 = new Definition($c546, $c547, "rev/min", $c548);
const $c549 = ["degC", "°C"];
const $c550 = $Decimal.of("1");
const $c551 = $Decimal.of("-273.15");
const $c369 = new Definition($c549, $c550, "K", $c551);
const $c552 = ["degF", "°F"];
const $c553 = $Decimal.of("0.5555555555555555555555555556");
const $c554 = $Decimal.of("-459.67");
const $c370 = new Definition($c552, $c553, "K", $c554);
const $c555 = ["%", "percent"];
const $c556 = $Decimal.of("0.01");
const $c557 = $Decimal.of("0");
const $c371 = new Definition($c555, $c556, "", $c557);
const $c22 = [$c310, $c311, $c312, $c313, $c314, $c315, $c316, $c317, $c318, $c319, $c320, $c321, $c322, $c323, $c324, $c325, $c326, $c327, $c328, $c329, $c330, $c331, $c332, $c333, $c334, $c335, $c336, $c337, $c338, $c339, $c340, $c341, $c342, $c343, $c344, $c345, $c346, $c347, $c348, $c349, $c350, $c351, $c352, $c353, $c354, $c355, $c356, $c357, $c358, $c359, $c360, $c361, $c362, $c363, $c364, $c365, $c366, $c367, $c368, $c369, $c370, $c371];
const $c23 = new Map([[181, "u"], [956, "u"], [8243, "\""], [8221, "\""], [186, "°"], [183, "*"], [8901, "*"], [215, "*"], [178, "2"], [179, "3"], [8315, "-"], [185, "1"], [160, " "], [8239, " "]]);
const $c24 = $re("(?<over>1|[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)?\\s*(?:/\\s*(?:(?<one>[A-Za-z°%\"]+(?:\\^?-?[1-9])?)|\\(\\s*(?<under>[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)\\s*\\)))?", "");
const $c25 = $re("([A-Za-z°%\"]+)(?:\\^?(-?[1-9]))?", "");
const $c26 = ["length", "force", "force_per_width", "spring_rate", "pressure", "pressure_per_length", "speed", "angle", "power", "torque", "area", "time", "temperature", "per_length", "wear_coefficient", "energy_per_area", "power_per_area", "rotation_speed", "mass", "mass_per_length", "mass_flow", "moment_of_inertia", "number"];
const $c558 = ["kind", "source", "date", "note"];
const $c27 = $made(Provenance, $c558, ["given", "", "", "from the coordinates of the pulleys"]);
const $c32 = [$c559, $c560, $c561, $c562];
const $c33 = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
const $c34 = new Map([["entry", "entry_tension"], ["exit", "exit_tension"]]);
const $c567 = ["material_mass", "capacity", "material_mass = \"120 kg/m\""];
const $c568 = ["take_up_tension", "counterweight", "take_up_tension = \"40 kN\""];
const $c569 = ["length_coefficient", "secondary_resistance", ""];
const $c570 = ["start_factor", "start_time", ""];
const $c36 = [$c567, $c568, $c569, $c570];
const $c37 = ["capacity", "start_time", "stop_time"];
const $c1445 = $made(Quantity, $c154, ["force", $c220]);
const $c1438 = $made(Entry, $c898, ["entry_tension", $c1445, false, "", "", "entry_tension", ""]);
const $c1439 = $made(Entry, $c898, ["exit_tension", $c1445, false, "", "", "exit_tension", ""]);
const $c1446 = $made(Quantity, $c154, ["force", null]);
const $c1440 = $made(Entry, $c898, ["effective_tension", $c1446, false, "", "", "effective_tension", ""]);
const $c1447 = $made(Quantity, $c154, ["power", null]);
const $c1441 = $made(Entry, $c898, ["power", $c1447, false, "", "", "power", ""]);
const $c1449 = $made(Quantity, $c154, ["force", null]);
const $c1448 = $made(ByName, $c906, [$c1449, 200]);
const $c1442 = $made(Entry, $c898, ["run", $c1448, false, "", "", "run", ""]);
const $c1602 = ["first", "second", "words"];
const $c1605 = $made(Limit, $c904, ["number", -100.0, 100.0, false, false]);
const $c1603 = $made(Quantity, $c154, ["number", $c1605]);
const $c1604 = $made(Quantity, $c154, ["power", null]);
const $c1451 = $made(Either, $c1602, [$c1603, $c1604, "a share like 0.5 or \"50 %\", or a power like \"300 kW\""]);
const $c1450 = $made(Rows, $c936, [$c1451, 1, 10]);
const $c1443 = $made(Entry, $c898, ["share", $c1450, false, "", "", "share", ""]);
const $c1453 = $made(SpeedList, [], []);
const $c1444 = $made(Entry, $c898, ["speeds", $c1453, false, "", "", "speeds", ""]);
const $c1436 = [$c1438, $c1439, $c1440, $c1441, $c1442, $c1443, $c1444];
const $c1437 = new Map([["entry_tension", $c1438], ["exit_tension", $c1439], ["effective_tension", $c1440], ["power", $c1441], ["run", $c1442], ["share", $c1443], ["speeds", $c1444]]);
const $c1435 = $made(tables$Table, $c883, [null, $c1436, $c1437]);
const $c1434 = $made(Entry, $c898, ["train", $c1435, false, "", "", "train", ""]);
const $c1432 = [$c1329, $c1330, $c1331, $c1332, $c1333, $c1434];
const $c1433 = new Map([["name", $c1329], ["description", $c1330], ["kind", $c1331], ["condition", $c1332], ["pulley", $c1333], ["train", $c1434]]);
const $c1431 = $made(tables$Table, $c883, [null, $c1432, $c1433]);
const $c1430 = $made(Rows, $c936, [$c1431, 1, 1000]);
const $c1428 = $made(Entry, $c898, ["load_case", $c1430, false, "", "", "load_case", ""]);
const $c1460 = $made(Quantity, $c154, ["length", $c210]);
const $c1459 = $made(Rows, $c936, [$c1460, 1, 10]);
const $c1457 = $made(Entry, $c898, ["diameters", $c1459, false, "", "", "diameters", ""]);
const $c1476 = ["converter"];
const $c1475 = $made(Choice, $c920, [$c1476]);
const $c1464 = $made(Entry, $c898, ["kind", $c1475, true, "", "", "kind", ""]);
const $c836 = $made(Limit, $c904, ["power", 0.0, 1000000000.0, true, false]);
const $c1477 = $made(Quantity, $c154, ["power", $c836]);
const $c1465 = $made(Entry, $c898, ["rated_power", $c1477, true, "", "", "rated_power", ""]);
const $c837 = $made(Limit, $c904, ["rotation_speed", 0.0, 100000.0, true, false]);
const $c1478 = $made(Quantity, $c154, ["rotation_speed", $c837]);
const $c1466 = $made(Entry, $c898, ["rated_speed", $c1478, true, "", "", "rated_speed", ""]);
const $c838 = $made(Limit, $c904, ["number", 0.0, 10000.0, true, false]);
const $c1479 = $made(Quantity, $c154, ["number", $c838]);
const $c1467 = $made(Entry, $c898, ["gear_ratio", $c1479, false, "", "", "gear_ratio", ""]);
const $c839 = $made(Limit, $c904, ["number", 0.05, 1.0, false, false]);
const $c1480 = $made(Quantity, $c154, ["number", $c839]);
const $c1468 = $made(Entry, $c898, ["gear_efficiency", $c1480, false, "", "", "gear_efficiency", ""]);
const $c840 = $made(Limit, $c904, ["number", 0.05, 1.0, false, false]);
const $c1481 = $made(Quantity, $c154, ["number", $c840]);
const $c1469 = $made(Entry, $c898, ["motor_efficiency", $c1481, false, "", "", "motor_efficiency", ""]);
const $c1482 = $made(Count, $c1323, [1, 8]);
const $c1470 = $made(Entry, $c898, ["count", $c1482, false, "", "", "count", ""]);
const $c1483 = $made(Flag, [], []);
const $c1471 = $made(Entry, $c898, ["brakes", $c1483, false, "", "", "brakes", ""]);
const $c842 = $made(Limit, $c904, ["number", 0.01, 3.0, false, false]);
const $c1484 = $made(Quantity, $c154, ["number", $c842]);
const $c1472 = $made(Entry, $c898, ["setting", $c1484, false, "", "", "setting", ""]);
const $c843 = $made(Limit, $c904, ["number", 0.0, 0.5, false, false]);
const $c1485 = $made(Quantity, $c154, ["number", $c843]);
const $c1473 = $made(Entry, $c898, ["droop", $c1485, false, "", "", "droop", ""]);
const $c844 = $made(Limit, $c904, ["number", 0.0, Infinity, true, true]);
const $c1487 = $made(Quantity, $c154, ["number", $c844]);
const $c1486 = $made(WordOr, $c934, ["rigid", $c1487, Infinity]);
const $c1474 = $made(Entry, $c898, ["torque_limit", $c1486, false, "", "", "torque_limit", ""]);
const $c1462 = [$c1464, $c1465, $c1466, $c1467, $c1468, $c1469, $c1470, $c1471, $c1472, $c1473, $c1474];
const $c1463 = new Map([["kind", $c1464], ["rated_power", $c1465], ["rated_speed", $c1466], ["gear_ratio", $c1467], ["gear_efficiency", $c1468], ["motor_efficiency", $c1469], ["count", $c1470], ["brakes", $c1471], ["setting", $c1472], ["droop", $c1473], ["torque_limit", $c1474]]);
const $c823 = $made(tables$Table, $c883, [VariableSpeed, $c1462, $c1463]);
const $c1500 = ["induction"];
const $c1499 = $made(Choice, $c920, [$c1500]);
const $c1490 = $made(Entry, $c898, ["kind", $c1499, true, "", "", "kind", ""]);
const $c1501 = $made(Quantity, $c154, ["power", $c836]);
const $c1491 = $made(Entry, $c898, ["rated_power", $c1501, true, "", "", "rated_power", ""]);
const $c1502 = $made(Quantity, $c154, ["rotation_speed", $c837]);
const $c1492 = $made(Entry, $c898, ["rated_speed", $c1502, true, "", "", "rated_speed", ""]);
const $c1503 = $made(Quantity, $c154, ["number", $c838]);
const $c1493 = $made(Entry, $c898, ["gear_ratio", $c1503, false, "", "", "gear_ratio", ""]);
const $c1504 = $made(Quantity, $c154, ["number", $c839]);
const $c1494 = $made(Entry, $c898, ["gear_efficiency", $c1504, false, "", "", "gear_efficiency", ""]);
const $c1505 = $made(Quantity, $c154, ["number", $c840]);
const $c1495 = $made(Entry, $c898, ["motor_efficiency", $c1505, false, "", "", "motor_efficiency", ""]);
const $c1506 = $made(Flag, [], []);
const $c1496 = $made(Entry, $c898, ["brakes", $c1506, false, "", "", "brakes", ""]);
const $c1508 = $made(Limit, $c904, ["rotation_speed", 0.0, 100000.0, true, false]);
const $c1507 = $made(Quantity, $c154, ["rotation_speed", $c1508]);
const $c1497 = $made(Entry, $c898, ["synchronous_speed", $c1507, true, "", "", "synchronous_speed", ""]);
const $c1510 = $made(Limit, $c904, ["number", 1.1, 10.0, false, false]);
const $c1509 = $made(Quantity, $c154, ["number", $c1510]);
const $c1498 = $made(Entry, $c898, ["breakdown_ratio", $c1509, false, "", "", "breakdown_ratio", ""]);
const $c1488 = [$c1490, $c1491, $c1492, $c1493, $c1494, $c1495, $c1470, $c1496, $c1497, $c1498];
const $c1489 = new Map([["kind", $c1490], ["rated_power", $c1491], ["rated_speed", $c1492], ["gear_ratio", $c1493], ["gear_efficiency", $c1494], ["motor_efficiency", $c1495], ["count", $c1470], ["brakes", $c1496], ["synchronous_speed", $c1497], ["breakdown_ratio", $c1498]]);
const $c824 = $made(tables$Table, $c883, [Induction, $c1488, $c1489]);
const $c1525 = ["fluid-coupling"];
const $c1524 = $made(Choice, $c920, [$c1525]);
const $c1513 = $made(Entry, $c898, ["kind", $c1524, true, "", "", "kind", ""]);
const $c1526 = $made(Quantity, $c154, ["power", $c836]);
const $c1514 = $made(Entry, $c898, ["rated_power", $c1526, true, "", "", "rated_power", ""]);
const $c1527 = $made(Quantity, $c154, ["rotation_speed", $c837]);
const $c1515 = $made(Entry, $c898, ["rated_speed", $c1527, true, "", "", "rated_speed", ""]);
const $c1528 = $made(Quantity, $c154, ["number", $c838]);
const $c1516 = $made(Entry, $c898, ["gear_ratio", $c1528, false, "", "", "gear_ratio", ""]);
const $c1529 = $made(Quantity, $c154, ["number", $c839]);
const $c1517 = $made(Entry, $c898, ["gear_efficiency", $c1529, false, "", "", "gear_efficiency", ""]);
const $c1530 = $made(Quantity, $c154, ["number", $c840]);
const $c1518 = $made(Entry, $c898, ["motor_efficiency", $c1530, false, "", "", "motor_efficiency", ""]);
const $c1531 = $made(Flag, [], []);
const $c1519 = $made(Entry, $c898, ["brakes", $c1531, false, "", "", "brakes", ""]);
const $c1532 = $made(Quantity, $c154, ["rotation_speed", $c1508]);
const $c1520 = $made(Entry, $c898, ["synchronous_speed", $c1532, true, "", "", "synchronous_speed", ""]);
const $c1533 = $made(Quantity, $c154, ["number", $c1510]);
const $c1521 = $made(Entry, $c898, ["breakdown_ratio", $c1533, false, "", "", "breakdown_ratio", ""]);
const $c1536 = $made(Limit, $c904, ["number", 0.0, 10.0, false, false]);
const $c1535 = $made(Quantity, $c154, ["number", $c1536]);
const $c1534 = $made(Rows, $c936, [$c1535, 2, 200]);
const $c1522 = $made(Entry, $c898, ["coupling_load", $c1534, true, "", "", "coupling_load", ""]);
const $c1523 = $made(Entry, $c898, ["coupling_slip", $c1534, true, "", "", "coupling_slip", ""]);
const $c1511 = [$c1513, $c1514, $c1515, $c1516, $c1517, $c1518, $c1470, $c1519, $c1520, $c1521, $c1522, $c1523];
const $c1512 = new Map([["kind", $c1513], ["rated_power", $c1514], ["rated_speed", $c1515], ["gear_ratio", $c1516], ["gear_efficiency", $c1517], ["motor_efficiency", $c1518], ["count", $c1470], ["brakes", $c1519], ["synchronous_speed", $c1520], ["breakdown_ratio", $c1521], ["coupling_load", $c1522], ["coupling_slip", $c1523]]);
const $c825 = $made(tables$Table, $c883, [FluidCoupling, $c1511, $c1512]);
const $c1543 = ["follower"];
const $c1542 = $made(Choice, $c920, [$c1543]);
const $c1539 = $made(Entry, $c898, ["kind", $c1542, true, "", "", "kind", ""]);
const $c1544 = $made(Name, $c908, [60]);
const $c1540 = $made(Entry, $c898, ["master", $c1544, true, "", "", "master", ""]);
const $c853 = $made(Limit, $c904, ["number", -10.0, 10.0, false, false]);
const $c1545 = $made(Quantity, $c154, ["number", $c853]);
const $c1541 = $made(Entry, $c898, ["ratio", $c1545, false, "", "", "ratio", ""]);
const $c1537 = [$c1539, $c1540, $c1541];
const $c1538 = new Map([["kind", $c1539], ["master", $c1540], ["ratio", $c1541]]);
const $c826 = $made(tables$Table, $c883, [TorqueFollower, $c1537, $c1538]);
const $c107 = new Map([["converter", $c823], ["induction", $c824], ["fluid-coupling", $c825], ["follower", $c826]]);
const $c108 = $made(Variant, $c1038, ["kind", $c107]);
const $c1461 = $made(ByName, $c906, [$c108, 200]);
const $c1458 = $made(Entry, $c898, ["motor", $c1461, false, "", "", "motor", ""]);
const $c1455 = [$c1438, $c1439, $c1440, $c1441, $c1442, $c1443, $c1444, $c1457, $c1458];
const $c1456 = new Map([["entry_tension", $c1438], ["exit_tension", $c1439], ["effective_tension", $c1440], ["power", $c1441], ["run", $c1442], ["share", $c1443], ["speeds", $c1444], ["diameters", $c1457], ["motor", $c1458]]);
const $c1454 = $made(tables$Table, $c883, [null, $c1455, $c1456]);
const $c1429 = $made(Entry, $c898, ["train", $c1454, false, "", "", "train", ""]);
const $c1426 = [$c886, $c887, $c888, $c889, $c890, $c891, $c892, $c893, $c1428, $c895, $c559, $c560, $c561, $c562, $c1429, $c897];
const $c1427 = new Map([["format", $c886], ["title", $c887], ["description", $c888], ["creep_limit", $c889], ["condition", $c890], ["belt", $c891], ["pulley", $c892], ["lagging", $c893], ["load_case", $c1428], ["conveyor", $c895], ["take_up", $c559], ["design_standard", $c560], ["safety_factor", $c561], ["sag", $c562], ["train", $c1429], ["motion", $c897]]);
const $c38 = $made(tables$Table, $c883, [Drive, $c1426, $c1427]);
const $c39 = $re("[A-Za-z0-9_-]{1,60}", "");
const $c40 = new Map([["The pulley carries its load.", true], ["Breakaway: no creep makes enough friction for this tension ratio. Raise the slack-side tension (take-up), enlarge the wrap angle, or choose a lagging with more friction.", false], ["The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.", false], ["The drives carry the load.", true], ["Breakaway: a drive cannot hold its part of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", false], ["No operating point: a motor would have to work beyond its curve. Change its set speed or gear, or choose another motor.", false], ["The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.", false]]);
const $c41 = new Map([["illustrative", "illustrative: it describes no real product"], ["calibrated", "calibrated: it was fitted to a known result"]]);
const $c42 = ["illustrative", "calibrated", "estimated"];
const $c43 = new WeakMap();
const $c1546 = ["name", "what", "missed", "fails_beyond", "tolerates", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "allowed", "limit", "rounded", "words", "asked"];
const $c44 = $made(Rule, $c1546, ["train_balance", "the balance of the train", "FAULT OF THE PROGRAM", NaN, NaN, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c45 = new Map([[false, "Motor torque over rated torque, running"], [true, "Motor torque over rated torque, momentary"]]);
const $c46 = $made(Rule, $c1546, ["momentary_load", "the torque that a motor bears in a start", "ATTENTION", NaN, NaN, true, "number", "", true, null, "", of_train___motor_torque, null, null, null, null, null]);
const $c47 = $made(Rule, $c1546, ["motor_load", "the rating of a motor", "ATTENTION", 1.15, NaN, true, "number", "", true, null, "", of_train___motor_torque, null, null, null, null, null]);
const $c48 = ["Speed"];
const $c49 = ["Motor"];
const $c50 = $made(Rule, $c1546, ["gross_slip", "the safety against gross slip", "ATTENTION", 1.0, NaN, false, "number", "raise", true, null, "", null, null, null, null, null, null]);
const $c572 = ["by creep", "The belt slides (creep of {slides})"];
const $c573 = ["by tested slip", "The slip leaves the tests of lagging ⟦lagging⟧"];
const $c574 = ["by the largest friction", "All friction of the wrap is used up"];
const $c51 = new Map([[0, $c572], [1, $c573], [2, $c574]]);
const $c52 = ["exit_creep", "peak_shear_stress", "largest_slip", "slip_speed"];
const $c575 = $made(Rule, $c1546, ["design_standard", "the design standard", "ATTENTION", NaN, NaN, false, "force", "raise", true, of_arc___binds, "", null, null, null, null, null, of_arc___standard]);
const $c576 = $made(Rule, $c1546, ["creep", "the creep limit", "ATTENTION", 0.0635, 0.0127, true, "length", "raise", true, null, "exit_creep", null, null, of_arc___creep_limit, null, of_arc___creeps, null]);
const $c577 = $made(Rule, $c1546, ["cover_creep", "the creep limit, with the cover of the belt in series", "ATTENTION", NaN, NaN, true, "length", "raise", false, null, "", null, null, null, null, null, of_arc___cover_creep]);
const $c578 = $made(Rule, $c1546, ["creep_interval", "the creep limit, at the end of the interval of the law", "ATTENTION", NaN, NaN, true, "length", "raise", false, null, "", null, null, null, null, null, in_page_checks__creep_interval]);
const $c579 = $made(Rule, $c1546, ["belt_tension", "the rating of the belt", "FAILS", NaN, NaN, true, "force", "lower", true, null, "", of_drive___tight, of_drive___running_tension, of_drive___over_width, null, of_drive___running, null]);
const $c580 = $made(Rule, $c1546, ["momentary_tension", "the momentary rating of the belt", "FAILS", NaN, NaN, true, "force", "lower", true, null, "", of_drive___tight, of_drive___momentary_tension, of_drive___over_width, null, of_drive___momentary, null]);
const $c581 = $made(Rule, $c1546, ["belt_safety", "the safety factor of the belt", "ATTENTION", 3.0, NaN, false, "number", "lower", true, of_drive___rated, "", of_drive___belt_safety, of_drive___asked_safety, null, of_drive___rounded_safety, of_drive___safety, null]);
const $c582 = $made(Rule, $c1546, ["face_pressure", "the pressure on the pulley face", "ATTENTION", NaN, NaN, true, "pressure", "lower", true, null, "", of_drive___tight_pressure, of_drive___face_pressure, null, null, of_drive___on_face, null]);
const $c583 = $made(Rule, $c1546, ["bond_stress", "the bond strength of the lagging", "ATTENTION", NaN, NaN, true, "pressure", "", true, null, "peak_shear_stress", null, of_arc___bond_strength, null, null, of_arc___bond, null]);
const $c584 = $made(Rule, $c1546, ["fatigue_stress", "the fatigue limit of the lagging", "ATTENTION", NaN, NaN, true, "pressure", "", true, null, "peak_shear_stress", null, of_arc___fatigue_limit, null, null, of_arc___tires, null]);
const $c585 = $made(Rule, $c1546, ["tested_pressure_max", "the largest wrap pressure tested", "ATTENTION", NaN, NaN, true, "pressure", "lower", true, null, "", of_drive___tight_pressure, of_drive___pressure_max, null, null, of_drive___tested_max, null]);
const $c586 = $made(Rule, $c1546, ["tested_pressure_min", "the least wrap pressure tested", "ATTENTION", NaN, NaN, false, "pressure", "raise", true, null, "", of_drive___slack_pressure, of_drive___pressure_min, null, null, of_drive___tested_min, null]);
const $c587 = $made(Rule, $c1546, ["condition", "friction that was not tested in the condition", "ATTENTION", NaN, NaN, true, "number", "", false, null, "", null, null, null, null, null, of_data___condition]);
const $c588 = $made(Rule, $c1546, ["fit", "friction that does not fit its tests", "ATTENTION", NaN, NaN, true, "number", "", false, null, "", null, null, null, null, null, of_data___fit]);
const $c589 = $made(Rule, $c1546, ["tested_slip", "the largest slip tested", "ATTENTION", NaN, NaN, true, "length", "raise", true, null, "largest_slip", null, of_arc___slip_max, null, null, of_arc___slips, null]);
const $c590 = $made(Rule, $c1546, ["tested_slip_speed", "the slip speed tested", "ATTENTION", NaN, NaN, true, "speed", "", false, null, "slip_speed", null, of_arc___tested_speed, null, null, of_arc___slips_fast, null]);
const $c591 = $made(Rule, $c1546, ["balance", "the energy balance", "FAULT OF THE PROGRAM", NaN, NaN, true, "number", "", false, null, "", null, null, null, null, null, of_arc___balance]);
const $c592 = $made(Rule, $c1546, ["sag", "the sag of the belt", "ATTENTION", NaN, NaN, false, "force", "raise", true, null, "", of_drive___slack_end, of_drive___sag_tension, null, null, of_drive___sags, null]);
const $c53 = [$c575, $c576, $c577, $c578, $c579, $c580, $c581, $c582, $c583, $c584, $c585, $c586, $c587, $c588, $c589, $c590, $c591, $c592];
const $c54 = $made(Rule, $c1546, ["pulley_diameter", "the least pulley of the belt", "FAILS", NaN, NaN, false, "length", "", true, null, "", of_drive___diameter, of_drive___least_diameter, null, null, of_drive___bends, null]);
const $c55 = ["Transition", "GrippingPulley"];
const $c611 = [1.0, 2.0];
const $c612 = [5000.0, 5000000.0];
const $c613 = [0.0004, 0.025];
const $c614 = [0.0004, 0.035];
const $c615 = [0.0004, 0.03];
const $c616 = [0.0015, 0.06];
const $c617 = [300000.0, 5000000.0];
const $c596 = new Map([["momentary_factor", $c611], ["in_plane_shear_stiffness", $c612], ["pulley_cover", $c613], ["carry_cover", $c614], ["carcass", $c615], ["thickness", $c616], ["cover_shear_modulus", $c617]]);
const $c618 = [0.2, 8.0];
const $c597 = new Map([["sheave_ratio", $c618]]);
const $c619 = [0.1, 0.9];
const $c620 = [1.0, 2.5];
const $c598 = new Map([["friction", $c619], ["start_factor", $c620]]);
const $c621 = [1.05, 6.0];
const $c622 = [1.0, 4.0];
const $c599 = new Map([["running", $c621], ["starting", $c622], ["braking", $c622]]);
const $c623 = [0.3, 8.0];
const $c624 = [1.0, 3000.0];
const $c625 = [0.002, 0.05];
const $c600 = new Map([["spacing", $c623], ["line_mass", $c624], ["share", $c625]]);
const $c626 = [1.0, 9.5];
const $c627 = [1.05, 2.5];
const $c601 = new Map([["length_coefficient", $c626], ["start_factor", $c627]]);
const $c628 = [300000.0, 100000000.0];
const $c629 = [1e-13, 1e-10];
const $c630 = [0.01, 1.0];
const $c602 = new Map([["elastic_modulus", $c628], ["wear_coefficient", $c629], ["belt_energy_share", $c630]]);
const $c631 = [0.002, 0.5];
const $c632 = [0.0005, 0.06];
const $c633 = [0.1, 4.0];
const $c634 = [0.15, 1.0];
const $c603 = new Map([["width", $c631], ["height", $c632], ["stiffening", $c633], ["contact_fraction", $c634]]);
const $c635 = [0.05, 200.0];
const $c604 = new Map([["area", $c635]]);
const $c636 = [0.05, 1.3];
const $c605 = new Map([["factor", $c636]]);
const $c637 = [0.3, 500.0];
const $c606 = new Map([["distance", $c637]]);
const $c638 = [0.2, 20.0];
const $c639 = [0.08726646259971647, 1.2217304763960306];
const $c640 = [0.05, 2.0];
const $c607 = new Map([["length", $c638], ["trough_angle", $c639], ["centre_roll", $c640]]);
const $c641 = [-0.01, 0.01];
const $c642 = [-0.005, 0.005];
const $c608 = new Map([["misalignment", $c641], ["deflection", $c642]]);
const $c643 = [1.0, 250.0];
const $c644 = [0.6, 1.0];
const $c645 = [0.5, 1.0];
const $c646 = [0.001, 0.15];
const $c647 = [0.8, 4.0];
const $c648 = [1.5, 5.0];
const $c609 = new Map([["gear_ratio", $c643], ["gear_efficiency", $c644], ["motor_efficiency", $c645], ["droop", $c646], ["torque_limit", $c647], ["breakdown_ratio", $c648]]);
const $c649 = [0.1, 5.0];
const $c610 = new Map([["ratio", $c649]]);
const $c56 = new Map([["Belt", $c596], ["TakeUp", $c597], ["DesignStandard", $c598], ["SafetyFactors", $c599], ["Sag", $c600], ["Conveyor", $c601], ["Lagging", $c602], ["Block", $c603], ["Cost", $c604], ["ConditionFactor", $c605], ["GrippingPulley", $c606], ["Transition", $c607], ["Across", $c608], ["Motor", $c609], ["TorqueFollower", $c610]]);
const $c650 = ["mm", "m", "cm", "in", "ft"];
const $c651 = ["kN", "N", "lbf", "kgf", "tf", "MN"];
const $c652 = ["kN/m", "N/m", "PIW", "N/mm", "MN/m"];
const $c653 = ["kPa", "MPa", "Pa", "psi", "bar", "GPa"];
const $c654 = ["m/s", "m/min", "ft/min", "km/h"];
const $c655 = ["deg", "rad"];
const $c656 = ["kW", "W", "hp", "MW"];
const $c657 = ["t", "kg", "g"];
const $c658 = ["kg/m", "g/m", "t/m"];
const $c659 = ["t/h", "kg/s", "kg/h"];
const $c660 = ["kg m2", "t m2", "kg cm2"];
const $c661 = ["kN m", "N m", "MN m"];
const $c662 = ["s", "min", "ms", "h"];
const $c57 = new Map([["length", $c650], ["force", $c651], ["force_per_width", $c652], ["pressure", $c653], ["speed", $c654], ["angle", $c655], ["power", $c656], ["mass", $c657], ["mass_per_length", $c658], ["mass_flow", $c659], ["moment_of_inertia", $c660], ["torque", $c661], ["time", $c662]]);
const $c58 = new Place("", "", "");
const $c59 = new Map([["shell_profile", 0.015], ["worn_depth", 0.025], ["build_up", 0.03]]);
const $c663 = ["rated power of the motor", "power"];
const $c664 = ["rated speed of the motor", "rotation_speed"];
const $c665 = ["speed of the drum over that of the belt", "number"];
const $c60 = [$c663, $c664, $c665];
const $c666 = [250.0, 20000000.0];
const $c667 = [10.0, 400.0];
const $c668 = [0.95, 1.05];
const $c61 = [$c666, $c667, $c668];
const $c669 = ["length", 3.0, 30000.0];
const $c670 = ["lift", -1500.0, 1500.0];
const $c671 = ["belt_mass", 3.0, 100.0];
const $c672 = ["carry_idler_mass", 2.0, 60.0];
const $c673 = ["return_idler_mass", 0.7, 30.0];
const $c674 = ["material_mass", 0.5, 4000.0];
const $c675 = ["capacity", 0.1, 15000.0];
const $c676 = ["friction_factor", 0.01, 0.04];
const $c677 = ["secondary_resistance", 10.0, 500000.0];
const $c678 = ["special_resistance", 10.0, 200000.0];
const $c679 = ["start_time", 1.0, 600.0];
const $c680 = ["stop_time", 1.0, 600.0];
const $c681 = ["take_up_tension", 300.0, 2000000.0];
const $c682 = ["counterweight", 30.0, 200000.0];
const $c62 = [$c669, $c670, $c671, $c672, $c673, $c674, $c675, $c676, $c677, $c678, $c679, $c680, $c681, $c682];
const $c63 = ["belt_mass", "carry_idler_mass", "return_idler_mass"];
const $c698 = $made(Limit, $c904, ["speed", 0.0, Infinity, true, false]);
const $c699 = $made(Limit, $c904, ["number", 0.01, 100.0, false, false]);
const $c64 = new Map([["length", $c683], ["lift", $c684], ["belt_mass", $c685], ["carry_idler_mass", $c686], ["return_idler_mass", $c687], ["material_mass", $c685], ["capacity", $c688], ["friction_factor", $c689], ["length_coefficient", $c690], ["secondary_resistance", $c691], ["special_resistance", $c691], ["return_share", $c692], ["start_factor", $c693], ["start_time", $c694], ["stop_time", $c694], ["take_up_tension", $c695], ["counterweight", $c696], ["take_up_distance", $c697], ["speed", $c698], ["sheave_ratio", $c699]]);
const $c700 = [0.2, 4.0];
const $c701 = [100000.0, 1000000000.0];
const $c702 = [0.05, 15.0];
const $c703 = [0.15, 3.0];
const $c704 = [0.17453292519943295, 4.71238898038469];
const $c705 = [2.0943951023931953, 4.71238898038469];
const $c706 = [0.0005, 0.061];
const $c707 = [-0.002, 0.002];
const $c708 = [0.0, 0.06];
const $c709 = [100000.0, 50000000.0];
const $c710 = [100000.0, 5000000000.0];
const $c711 = [5000.0, 2000000.0];
const $c712 = [10000.0, 50000000.0];
const $c713 = [50000.0, 10000000.0];
const $c714 = [0.1, 3.0];
const $c715 = [500.0, 10000000.0];
const $c716 = [4.0, 20.0];
const $c717 = [15.0, 1000.0];
const $c718 = [0.0, 1600000.0];
const $c719 = [1.0, 130.0];
const $c65 = [$c700, $c701, $c702, $c703, $c704, $c705, $c706, $c707, $c708, $c709, $c710, $c711, $c712, $c712, $c713, $c714, $c715, $c716, $c717, $c718, $c715, $c715, $c666, $c719];
const $c724 = [500.0, 2000000.0];
const $c720 = ["least tested pressure", "pressure", $c724];
const $c725 = [10000.0, 10000000.0];
const $c721 = ["largest tested pressure", "pressure", $c725];
const $c726 = [5e-05, 0.3];
const $c722 = ["largest tested slip", "length", $c726];
const $c727 = [2e-06, 0.3];
const $c723 = ["tested slip speed", "speed", $c727];
const $c66 = new Map([["pressure_min", $c720], ["pressure_max", $c721], ["slip_max", $c722], ["slip_speed", $c723]]);
const $c67 = [0.03, 1.9];
const $c68 = ["force", "mass_per_length"];
const $c69 = new Map([["illustrative", "on illustrative data"], ["untested", "on friction without tests"], ["estimated", "on estimated data"], ["calibrated", "on calibrated data"]]);
const $c70 = new WeakMap();
const $c730 = [180.0, 1.2];
const $c731 = [200.0, 1.0];
const $c732 = [210.0, 1.0];
const $c733 = [220.0, 0.9];
const $c734 = [240.0, 0.8];
const $c728 = [$c730, $c731, $c732, $c733, $c734];
const $c735 = [180.0, 0.8];
const $c736 = [200.0, 0.7];
const $c737 = [210.0, 0.7];
const $c738 = [220.0, 0.6];
const $c739 = [240.0, 0.6];
const $c729 = [$c735, $c736, $c737, $c738, $c739];
const $c71 = new Map([["bare", $c728], ["lagged", $c729]]);
const $c761 = ["standard", "surface", "condition", "friction", "provenance"];
const $c762 = [0.25, 0.25];
const $c763 = $made(Provenance, $c558, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $c740 = $made(DesignFriction, $c761, ["CEMA", "bare", "", $c762, $c763]);
const $c764 = [0.35, 0.35];
const $c765 = $made(Provenance, $c558, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $c741 = $made(DesignFriction, $c761, ["CEMA", "rubber", "", $c764, $c765]);
const $c766 = [0.5, 0.5];
const $c767 = $made(Provenance, $c558, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", "dimpled ceramic"]);
const $c742 = $made(DesignFriction, $c761, ["CEMA", "ceramic", "", $c766, $c767]);
const $c768 = [0.35, 0.4];
const $c769 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c743 = $made(DesignFriction, $c761, ["DIN 22101", "bare", "dry", $c768, $c769]);
const $c770 = [0.1, 0.1];
const $c771 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c744 = $made(DesignFriction, $c761, ["DIN 22101", "bare", "wet", $c770, $c771]);
const $c772 = [0.05, 0.1];
const $c773 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c745 = $made(DesignFriction, $c761, ["DIN 22101", "bare", "wet and dirty", $c772, $c773]);
const $c774 = [0.4, 0.45];
const $c775 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c746 = $made(DesignFriction, $c761, ["DIN 22101", "rubber", "dry", $c774, $c775]);
const $c776 = [0.35, 0.35];
const $c777 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves; single value, partly from IS 11592 and REMA"]);
const $c747 = $made(DesignFriction, $c761, ["DIN 22101", "rubber", "wet", $c776, $c777]);
const $c778 = [0.25, 0.3];
const $c779 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c748 = $made(DesignFriction, $c761, ["DIN 22101", "rubber", "wet and dirty", $c778, $c779]);
const $c780 = [0.35, 0.4];
const $c781 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c749 = $made(DesignFriction, $c761, ["DIN 22101", "polyurethane", "dry", $c780, $c781]);
const $c782 = [0.35, 0.35];
const $c783 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c750 = $made(DesignFriction, $c761, ["DIN 22101", "polyurethane", "wet", $c782, $c783]);
const $c784 = [0.2, 0.2];
const $c785 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c751 = $made(DesignFriction, $c761, ["DIN 22101", "polyurethane", "wet and dirty", $c784, $c785]);
const $c786 = [0.4, 0.45];
const $c787 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c752 = $made(DesignFriction, $c761, ["DIN 22101", "ceramic", "dry", $c786, $c787]);
const $c788 = [0.35, 0.4];
const $c789 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", ""]);
const $c753 = $made(DesignFriction, $c761, ["DIN 22101", "ceramic", "wet", $c788, $c789]);
const $c790 = [0.35, 0.35];
const $c791 = $made(Provenance, $c558, ["published", "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c754 = $made(DesignFriction, $c761, ["DIN 22101", "ceramic", "wet and dirty", $c790, $c791]);
const $c792 = [0.35, 0.35];
const $c793 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c755 = $made(DesignFriction, $c761, ["practice", "rubber", "dry", $c792, $c793]);
const $c794 = [0.35, 0.35];
const $c795 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c756 = $made(DesignFriction, $c761, ["practice", "rubber", "wet", $c794, $c795]);
const $c796 = [0.3, 0.3];
const $c797 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c757 = $made(DesignFriction, $c761, ["practice", "rubber", "wet and dirty", $c796, $c797]);
const $c798 = [0.8, 0.8];
const $c799 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c758 = $made(DesignFriction, $c761, ["practice", "ceramic", "dry", $c798, $c799]);
const $c800 = [0.45, 0.45];
const $c801 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c759 = $made(DesignFriction, $c761, ["practice", "ceramic", "wet", $c800, $c801]);
const $c802 = [0.35, 0.35];
const $c803 = $made(Provenance, $c558, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c760 = $made(DesignFriction, $c761, ["practice", "ceramic", "wet and dirty", $c802, $c803]);
const $c72 = [$c740, $c741, $c742, $c743, $c744, $c745, $c746, $c747, $c748, $c749, $c750, $c751, $c752, $c753, $c754, $c755, $c756, $c757, $c758, $c759, $c760];
const $c73 = new Set(["cover_creep", "creep", "creep_interval", "design_standard", "gross_slip", "sag", "tested_pressure_min", "tested_slip", "uneven_creep"]);
const $c74 = new Set(["belt_safety", "belt_tension", "edge_tension", "face_pressure", "momentary_tension", "tested_pressure_max", "uneven_face_pressure", "uneven_pressure"]);
const $c75 = new Map([["uneven_creep", "creep"], ["uneven_pressure", "tested_pressure_max"], ["uneven_face_pressure", "face_pressure"], ["uneven_bond_stress", "bond_stress"], ["uneven_fatigue_stress", "fatigue_stress"], ["edge_tension", "belt_tension"]]);
const $c804 = $made(Rule, $c1546, ["taut", "a belt that nowhere hangs slack", "ATTENTION", NaN, NaN, false, "number", "", true, null, "", null, null, null, null, null, null]);
const $c805 = $made(Rule, $c1546, ["belt_thickness", "a trim without the thickness of the belt", "ATTENTION", NaN, NaN, true, "number", "", true, null, "", null, null, null, null, null, null]);
const $c806 = $made(Rule, $c1546, ["usual_sizes", "an unusual size", "ATTENTION", NaN, NaN, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c807 = $made(Rule, $c1546, ["motor_heat", "the heat that a motor bears", "ATTENTION", NaN, NaN, true, "time", "", true, null, "", null, null, null, null, null, null]);
const $c76 = new Map([["gross_slip", $c50], ["design_standard", $c575], ["creep", $c576], ["cover_creep", $c577], ["creep_interval", $c578], ["belt_tension", $c579], ["momentary_tension", $c580], ["belt_safety", $c581], ["face_pressure", $c582], ["bond_stress", $c583], ["fatigue_stress", $c584], ["tested_pressure_max", $c585], ["tested_pressure_min", $c586], ["condition", $c587], ["fit", $c588], ["tested_slip", $c589], ["tested_slip_speed", $c590], ["balance", $c591], ["sag", $c592], ["taut", $c804], ["pulley_diameter", $c54], ["belt_thickness", $c805], ["usual_sizes", $c806], ["motor_load", $c47], ["momentary_load", $c46], ["motor_heat", $c807], ["train_balance", $c44]]);
const $c77 = new Map([["distributed", "distributed"], ["paper", "paper's march"]]);
const $c78 = new WeakMap();
const $c811 = ["name", "surface", "material", "life_years", "provenance"];
const $c812 = [1, 2];
const $c813 = $made(Provenance, $c558, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $c808 = $made(LaggingCost, $c811, ["rubber", "rubber", 625, $c812, $c813]);
const $c814 = [10, 10];
const $c815 = $made(Provenance, $c558, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $c809 = $made(LaggingCost, $c811, ["ceramic, cold bonded", "ceramic", 4600, $c814, $c815]);
const $c816 = [10, 10];
const $c817 = $made(Provenance, $c558, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $c810 = $made(LaggingCost, $c811, ["ceramic, hot vulcanised", "ceramic", 4950, $c816, $c817]);
const $c79 = [$c808, $c809, $c810];
const $c80 = $made(Provenance, $c558, ["given", "", "", "estimated: belt covers have 0.8 to 1.5 MPa (116 to 218 psi)"]);
const $c81 = $made(Provenance, $c558, ["given", "", "", ""]);
const $c82 = $made(Provenance, $c558, ["published", "B. DeVries, A model of lagging friction as a function of creep history and wrap pressure", "", "the conservative customary limit"]);
const $c83 = new Map([["entry_tension", "T1"], ["exit_tension", "T2"]]);
const $c84 = $re("\\.?([A-Za-z_][A-Za-z0-9_-]*)|\\[(\\d+)\\]", "");
const $c85 = ["format", "name", "title", "description", "surface", "thickness", "elastic_modulus", "shear_modulus", "compression_modulus", "block", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "slip_speed", "temperature", "condition_factor", "law", "provenance", "sources", "notes"];
const $c86 = ["name", "title", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "description"];
const $c88 = ["elastic_modulus", "shear_modulus", "compression_modulus", "block"];
const $c89 = ["thickness", "shear_modulus", "compression_modulus"];
const $c90 = new Map([["width", $c818], ["height", $c819], ["stiffening", $c820], ["contact_fraction", $c821]]);
const $c93 = new Map([["friction_coefficient", "friction"], ["slip_max", "tested_slip"], ["tested", "tested_pressure"], ["pieces.a", "A"], ["values", "rows"], ["peak_friction", "knots"], ["peak_slip", "knots"], ["post_peak_slope", "knots"], ["residual_friction", "knots"]]);
const $c94 = new Map([["integral-log", "knots"], ["table", "rows"]]);
const $c96 = $re("\\s*(?<sign>[+-])?\\s*(?<number>(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)?\\s*\\*?\\s*(?<factor>p(?:\\s*\\^\\s*(?:\\(\\s*(?<within>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\\s*\\)|(?<power>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)))?|ln\\(\\s*p\\s*\\)(?:\\s*\\^\\s*(?<log_power>[123]))?|exp\\((?<exponent>(?:[^()]|\\(\\s*p\\s*\\))*)\\))?\\s*", "");
const $c1558 = $made(Name, $c908, [60]);
const $c1549 = $made(Entry, $c898, ["name", $c1558, true, "", "name = \"my-lagging\"", "name", ""]);
const $c1559 = $made(Quantity, $c154, ["length", $c845]);
const $c1550 = $made(Entry, $c898, ["thickness", $c1559, false, "", "", "thickness", ""]);
const $c1560 = $made(Quantity, $c154, ["pressure", $c848]);
const $c1551 = $made(Entry, $c898, ["elastic_modulus", $c1560, false, "", "", "elastic_modulus", ""]);
const $c1562 = $made(Quantity, $c154, ["pressure", $c846]);
const $c1561 = $made(WordOr, $c934, ["rigid", $c1562, Infinity]);
const $c1552 = $made(Entry, $c898, ["shear_modulus", $c1561, false, "", "", "shear_modulus", ""]);
const $c1564 = $made(Quantity, $c154, ["pressure", $c847]);
const $c1563 = $made(WordOr, $c934, ["rigid", $c1564, Infinity]);
const $c1553 = $made(Entry, $c898, ["compression_modulus", $c1563, false, "", "", "compression_modulus", ""]);
const $c1565 = $made(Quantity, $c154, ["wear_coefficient", $c849]);
const $c1554 = $made(Entry, $c898, ["wear_coefficient", $c1565, false, "", "", "wear_coefficient", ""]);
const $c1566 = $made(Quantity, $c154, ["number", $c850]);
const $c1555 = $made(Entry, $c898, ["belt_energy_share", $c1566, false, "", "", "belt_energy_share", ""]);
const $c1567 = $made(Quantity, $c154, ["pressure", $c851]);
const $c1556 = $made(Entry, $c898, ["bond_strength", $c1567, false, "", "", "bond_strength", ""]);
const $c1568 = $made(Quantity, $c154, ["pressure", $c852]);
const $c1557 = $made(Entry, $c898, ["fatigue_limit", $c1568, false, "", "", "fatigue_limit", ""]);
const $c1547 = [$c886, $c1549, $c963, $c964, $c965, $c1550, $c1551, $c1552, $c1553, $c970, $c1554, $c1555, $c1556, $c1557, $c975, $c976, $c977, $c978, $c979, $c147, $c148, $c980];
const $c1548 = new Map([["format", $c886], ["name", $c1549], ["title", $c963], ["description", $c964], ["surface", $c965], ["thickness", $c1550], ["elastic_modulus", $c1551], ["shear_modulus", $c1552], ["compression_modulus", $c1553], ["block", $c970], ["wear_coefficient", $c1554], ["belt_energy_share", $c1555], ["bond_strength", $c1556], ["fatigue_limit", $c1557], ["cost", $c975], ["slip_speed", $c976], ["temperature", $c977], ["condition_factor", $c978], ["law", $c979], ["provenance", $c147], ["sources", $c148], ["notes", $c980]]);
const $c100 = $made(tables$Table, $c883, [Lagging, $c1547, $c1548]);
const $c822 = ["compression_modulus", "block"];
const $c101 = [$c822];
const $c102 = new Set(["belt_energy_share", "block", "bond_strength", "compression_modulus", "condition_factor", "cost", "elastic_modulus", "fatigue_limit", "law", "shear_modulus", "slip_speed", "temperature", "thickness", "wear_coefficient"]);
const $c103 = new RunsGain(0.0, 0.0);
const $c105 = ["effective_tension", "torque", "power"];
const $c106 = ["share", "speeds", "motor"];
const $c109 = ["data", "sense"];
const $c110 = new Map([["NOT CHECKED", 0], ["OK", 1], ["ATTENTION", 2], ["FAILS", 3], ["FAULT OF THE PROGRAM", 4]]);
const $c111 = $Decimal.of("0");
const $c112 = [""];
const $c827 = ["form", "coefficients", "sign"];
const $c828 = [0.0];
const $c113 = $made(Trend, $c827, ["polynomial", $c828, 1]);
const $c829 = [1000000000.0];
const $c114 = $made(Trend, $c827, ["polynomial", $c829, 1]);
const $c115 = new Map([["factor", $c830]]);
const $c116 = new Map([["x", $c831], ["y", $c831], ["diameter", $c832]]);
const $c833 = $made(Limit, $c904, ["force", 0.1, 1000000000.0, false, false]);
const $c117 = new Map([["entry", $c220], ["exit", $c833]]);
const $c118 = new Map([["creep_limit", $c834]]);
const $c835 = $made(Limit, $c904, ["length", 0.0, Infinity, true, false]);
const $c119 = new Map([["creep_limit", $c835]]);
const $c841 = $made(Limit, $c904, ["number", 1, 8, false, false]);
const $c120 = new Map([["rated_power", $c836], ["rated_speed", $c837], ["gear_ratio", $c838], ["gear_efficiency", $c839], ["motor_efficiency", $c840], ["count", $c841]]);
const $c121 = new Map([["rated_power", $c836], ["rated_speed", $c837], ["gear_ratio", $c838], ["gear_efficiency", $c839], ["motor_efficiency", $c840], ["count", $c841], ["setting", $c842], ["droop", $c843], ["torque_limit", $c844]]);
const $c122 = new Map([["thickness", $c845], ["shear_modulus", $c846], ["compression_modulus", $c847], ["elastic_modulus", $c848], ["wear_coefficient", $c849], ["belt_energy_share", $c850], ["bond_strength", $c851], ["fatigue_limit", $c852]]);
const $c123 = new Map([["ratio", $c853]]);
const $c124 = new Map([["entry_tension", $c220], ["exit_tension", $c833]]);
const $c125 = new Map([["sheave_ratio", $c854]]);
const $c126 = new Map([["friction", $c855], ["start_factor", $c856]]);
const $c127 = new Map([["running", $c856], ["starting", $c856], ["braking", $c856]]);
const $c128 = ["of"];
const $c149 = ["key", "kind", "example", "attribute"];
const $c156 = ["dimension", "least"];
const $c158 = ["word", "kind"];
const $c189 = ["kind"];
const $c215 = ["text"];
const $c571 = ["name", "what", "missed", "at_most", "dimension", "tension", "binding", "firm", "value", "allowed", "limit", "words"];
const $c593 = new Map([["steel cord", 1600000.0], ["fabric", 140000.0]]);
const $c594 = new Map([["steel cord", 6.666666666666667], ["fabric", 8.0]]);
const $c595 = ["name", "what", "missed", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "allowed", "limit", "words"];
const $c857 = ["balance", "train_balance", "across_balance"];
const $c858 = ["cover_creep", "creep_interval", "tested_slip_speed"];
const $c859 = ["gross_slip", "operating_point", "fight"];
const $c860 = ["on illustrative data", "on friction without tests", "on estimated data", "on calibrated data"];
const $c1569 = [false, false];
const $c1570 = [true, false];
const $c1571 = [true, true];
const $c1572 = [false, true];
const $c861 = new Map([["polynomial", $c1569], ["logarithmic", $c1570], ["power", $c1571], ["exponential", $c1572]]);
const $c866 = $made(_OfClass, [], []);
const $c867 = new Map([[10, null], [9, null]]);
const $c868 = $re("(?:ST[ -]?|(?:\\b(?:EP|EE|NN|PN|NP|PP|EB)[ -]?|^)(?=\\d+/\\d))(\\d{3,5})\\b", "");
const $c1573 = [80.0, 1.92];
const $c1574 = [90.0, 1.86];
const $c1575 = [100.0, 1.78];
const $c1576 = [120.0, 1.7];
const $c1577 = [140.0, 1.63];
const $c1578 = [160.0, 1.56];
const $c1579 = [180.0, 1.5];
const $c1580 = [200.0, 1.45];
const $c1581 = [250.0, 1.38];
const $c1582 = [300.0, 1.31];
const $c1583 = [350.0, 1.27];
const $c1584 = [400.0, 1.25];
const $c1585 = [450.0, 1.22];
const $c1586 = [500.0, 1.2];
const $c1587 = [550.0, 1.18];
const $c1588 = [600.0, 1.17];
const $c1589 = [700.0, 1.14];
const $c1590 = [800.0, 1.12];
const $c1591 = [900.0, 1.1];
const $c1592 = [1000.0, 1.09];
const $c1593 = [1500.0, 1.06];
const $c1594 = [2000.0, 1.05];
const $c871 = [$c1573, $c1574, $c1575, $c1576, $c1577, $c1578, $c1579, $c1580, $c1581, $c1582, $c1583, $c1584, $c1585, $c1586, $c1587, $c1588, $c1589, $c1590, $c1591, $c1592, $c1593, $c1594];
const $c1595 = $made(Limit, $c904, ["number", 0.0, Infinity, false, false]);
const $c1596 = $made(Limit, $c904, ["number", 1.0, Infinity, false, false]);
const $c873 = new Map([["residual_noise", $c1595], ["coverage_factor", $c1596]]);
const $c874 = $re("knots\\[([0-9]{1,4})\\]\\.(peak_slip|peak_friction)", "");
const $c875 = $Decimal.of("0");
const $c876 = new Map([["misalignment", $c1263], ["deflection", $c1265]]);
const $c877 = new Map([["diameter", $c210], ["wrap_angle", $c212], ["overrun", $c226], ["creep_limit", $c229], ["mass", $c232]]);
const $c878 = new Map([["spacing", $c1419], ["line_mass", $c1421], ["share", $c1423]]);
const $c879 = new Map([["material", $c1016], ["installation", $c1018], ["area", $c1021]]);
const $c1597 = $made(Limit, $c904, ["number", 0.0, 10.0, true, false]);
const $c880 = new Map([["factor", $c1597]]);
const $c881 = new Map([["rated_power", $c836], ["rated_speed", $c837], ["gear_ratio", $c838], ["gear_efficiency", $c839], ["motor_efficiency", $c840], ["count", $c841], ["synchronous_speed", $c1508], ["breakdown_ratio", $c1510]]);
const $c882 = new Map([["length", $c1307], ["trough_angle", $c1309], ["centre_roll", $c1311]]);
const $c1197 = ["dimension", "within"];
const $c1452 = ["words"];
const $c1598 = [0.016, 0.03];
const $c1599 = new Map([["distance", $c1296]]);
const $c1609 = $made(Limit, $c904, ["number", 0.0, 10.0, true, false]);
const $c1607 = $made(Quantity, $c154, ["number", $c1609]);
const $c1610 = $made(Limit, $c904, ["rotation_speed", 0.0, Infinity, true, false]);
const $c1608 = $made(Quantity, $c154, ["rotation_speed", $c1610]);
const $c1606 = $made(Either, $c1602, [$c1607, $c1608, "a trim like \"99.7 %\" or a drum speed like \"71.6 rpm\""]);
const $c1600 = $made(Rows, $c936, [$c1606, 1, 10]);
Problem.$compared = Problem.$names;
$sig(InputError, ["problems"], false);
$sig(Report, ["file"], false);
$sig(Report.prototype.add, ["place", "message", "remedy", "value", "code"], false);
$sig(Record, ["values", "place", "raw", "faulty"], false);
Provenance.$compared = Provenance.$names;
$sig(Laggings, ["own", "folder", "allow_paths", "report"], false);
Condition.$compared = Condition.$names;
Condition.LIMITS = Condition.prototype.LIMITS = $c115;
Conditions.$compared = Conditions.$names;
Point.$compared = Point.$names;
Point.LIMITS = Point.prototype.LIMITS = $c116;
$sig(_UnitTextError, ["message", "remedy"], false);
Unit.$compared = Unit.$names;
UnitRow.$compared = UnitRow.$names;
WidthProfile.$compared = WidthProfile.$names;
Criteria.$compared = Criteria.$names;
Layers.$compared = Layers.$names;
Given.$compared = Given.$names;
$sig(Given.prototype.overridden, ["record", "fixed", "speed", "runs"], false);
NipTensions.$compared = NipTensions.$names;
Tensions.$compared = ["entry", "exit"];
Tensions.LIMITS = Tensions.prototype.LIMITS = $c117;
LoadCase.$compared = LoadCase.$names;
Drive.$compared = ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description"];
Drive.LIMITS = Drive.prototype.LIMITS = $c118;
Train.$compared = Train.$names;
Train.LIMITS = Train.prototype.LIMITS = $c119;
$sig(Reader, ["record", "belt", "pulleys", "report", "take_up"], false);
CatalogueBelt.$compared = CatalogueBelt.$names;
WrapArc.$compared = WrapArc.$names;
$sig(WrapArc.on, ["belt", "pulley", "lagging"], true);
in_page$Given.$compared = in_page$Given.$names;
Rise.$compared = Rise.$names;
in_page$Criteria.$compared = in_page$Criteria.$names;
Place.$compared = Place.$names;
Motors.$compared = Motors.$names;
Motor.$compared = Motor.$names;
Motor.LIMITS = Motor.prototype.LIMITS = $c120;
Check.$compared = Check.$names;
Pulls.$compared = Pulls.$names;
Shares.$compared = Shares.$names;
Words.$compared = Words.$names;
Speeds.$compared = Speeds.$names;
Owner.$compared = Owner.$names;
Sliding.$compared = Sliding.$names;
VariableSpeed.$compared = VariableSpeed.$names;
VariableSpeed.LIMITS = VariableSpeed.prototype.LIMITS = $c121;
Sizes.$compared = Sizes.$names;
Figure.$compared = Figure.$names;
Asked.$compared = Asked.$names;
LeastTension.$compared = LeastTension.$names;
Verdict.$compared = Verdict.$names;
Row.$compared = Row.$names;
Table.$compared = Table.$names;
FrictionLaw.$compared = FrictionLaw.$names;
Constant.$compared = Constant.$names;
Constant.title = Constant.prototype.title = "constant friction (Euler-Eytelwein)";
PressurePower.$compared = PressurePower.$names;
PressurePower.title = PressurePower.prototype.title = "power of pressure";
ClassicalDrive.$compared = ClassicalDrive.$names;
Input.$compared = Input.$names;
$sig(Sources, [], false);
TestedRange.$compared = TestedRange.$names;
MeasuredTable.$compared = MeasuredTable.$names;
MeasuredTable.title = MeasuredTable.prototype.title = "measured table";
_Term.$compared = _Term.$names;
Trend.$compared = Trend.$names;
Piece.$compared = Piece.$names;
CoefficientPieces.$compared = CoefficientPieces.$names;
PressureKnots.$compared = PressureKnots.$names;
IntegralLog.$compared = IntegralLog.$names;
IntegralLog.title = IntegralLog.prototype.title = "integral-log law";
Factors.$compared = Factors.$names;
Lagging.$compared = ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "provenance", "sources", "notes", "description"];
Lagging.LIMITS = Lagging.prototype.LIMITS = $c122;
LoadGiven.$compared = LoadGiven.$names;
DrumAt.$compared = DrumAt.$names;
Pair.$compared = Pair.$names;
TorqueFollower.$compared = TorqueFollower.$names;
TorqueFollower.LIMITS = TorqueFollower.prototype.LIMITS = $c123;
TrainCase.$compared = TrainCase.$names;
TrainCase.LIMITS = TrainCase.prototype.LIMITS = $c124;
RunsGain.$compared = RunsGain.$names;
BehindTakeUp.$compared = BehindTakeUp.$names;
Description.$compared = Description.$names;
CompactLaw.$compared = CompactLaw.$names;
TakeUp.$compared = TakeUp.$names;
TakeUp.LIMITS = TakeUp.prototype.LIMITS = $c125;
DesignStandard.$compared = DesignStandard.$names;
DesignStandard.LIMITS = DesignStandard.prototype.LIMITS = $c126;
SafetyFactors.$compared = SafetyFactors.$names;
SafetyFactors.LIMITS = SafetyFactors.prototype.LIMITS = $c127;
$sig(Kind.prototype.built, ["value", "report"], true);
$sig(tables$Table, null);
$sig(tables$Table.prototype.built, ["value", "report"], true);
Limit.$compared = Limit.$names;
Belt.$compared = Belt.$names;
Belt.LIMITS = Belt.prototype.LIMITS = $c4;
Across.$compared = Across.$names;
Across.LIMITS = Across.prototype.LIMITS = $c876;
DimensionText.$compared = DimensionText.$names;
Definition.$compared = Definition.$names;
$sig(Variant, ["tag", "meaning"], false);
$sig(Variant.prototype.built, ["value", "report"], true);
Pulley.$compared = Pulley.$names;
Pulley.LIMITS = Pulley.prototype.LIMITS = $c877;
Sag.$compared = Sag.$names;
Sag.SOURCE = Sag.prototype.SOURCE = "belt sag: T = m' g l/(8 h), a parabola; the rule of DIN 22101 and of CEMA, Belt Conveyors for Bulk Materials (6.25 S W for 2 %, 4.2 S W for 3 %)";
Sag.LIMITS = Sag.prototype.LIMITS = $c878;
Conveyor.$compared = Conveyor.$names;
Conveyor.LIMITS = Conveyor.prototype.LIMITS = $c64;
DesignFriction.$compared = DesignFriction.$names;
LaggingCost.$compared = LaggingCost.$names;
Cost.$compared = Cost.$names;
Cost.LIMITS = Cost.prototype.LIMITS = $c879;
Block.$compared = Block.$names;
Block.LIMITS = Block.prototype.LIMITS = $c90;
ConditionFactor.$compared = ConditionFactor.$names;
ConditionFactor.LIMITS = ConditionFactor.prototype.LIMITS = $c880;
FrictionFactor.$compared = FrictionFactor.$names;
Fit.$compared = Fit.$names;
Induction.$compared = Induction.$names;
Induction.LIMITS = Induction.prototype.LIMITS = $c881;
FluidCoupling.$compared = FluidCoupling.$names;
Load.$compared = Load.$names;
Transition.$compared = Transition.$names;
Transition.LIMITS = Transition.prototype.LIMITS = $c882;
conveyor$State.$compared = conveyor$State.$names;
Resistance.$compared = Resistance.$names;
Miss.$compared = Miss.$names;
ElasticPlastic.$compared = ElasticPlastic.$names;
ElasticPlastic.title = ElasticPlastic.prototype.title = "elastic-plastic";
$sig(Profile, ["dimension", "diameters"], false);
Profile.words = Profile.prototype.words = "rows, or a table";
$sig(_Pair, ["dimension"], false);
GrippingPulley.$compared = GrippingPulley.$names;
GrippingPulley.LIMITS = GrippingPulley.prototype.LIMITS = $c1599;
Either.$compared = Either.$names;
SpeedList.$compared = SpeedList.$names;
SpeedList.rows = SpeedList.prototype.rows = $c1600;
$sig(sheet__row_of, null);
$sig(sheet__between, ["name", "first", "last", "form"], false);
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
export { in_page_checks__idle_in as idleIn };
export { judge__judge as judge };
export { least_tension__least_tension as leastTension };
export { least_tension__least_sentence as leastSentence };
export { least_tension__least_table as leastTable };
export { least_tension__shown_least as shownLeast };
export { checks_table__check_table as checkTable };
export { words__short as short };
export { drive_sheet__summary_table as summaryTable };
export { drive_sheet__arc_tables as arcTables };
export { Sources as Sources };
export { words__alone_of as aloneOf };
