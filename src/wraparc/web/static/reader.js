// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import { belts, isNumber, laggingNames, laggingText, overridden, parsed, readText } from "./documents.js";
import { $Decimal, $Dict, $Error, $Object, $OverflowError, $TypeError, $add, $and, $at, $b, $bound, $call, $eq, $fields, $format, $in, $iter, $k, $m, $made, $map, $math, $merged, $method, $mul, $neg, $once, $or, $pow, $put, $re, $replaced, $repr, $shown, $sig, $slice, $str, $sub, $truth } from "./python.js";
function drive_file__drive_from_document(document, file = "", folder = "", overrides = [], allow_paths = false) {
let belt, belt_record, cases, conditions, conveyor, criteria, laggings, message, own, parts, pulleys, record, records, report;

(document = $call(overridden, [document, overrides], [["file", file]]));
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
throw new InputError($call(Problem, [], [["message", message], ["remedy", remedy], ["file", file], ["key", "format"], ["value", $shown(given)]]));
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
return new InputError($call(Problem, [], [["message", ("" + "the catalogue has no " + $str(what) + " of this name")], ["remedy", $m.strip(("" + $str(remedy) + " The command `" + $str(command) + "` lists them."))], ["value", $shown(name)]]));
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
return $call(Condition, [], [["name", $b.str(value)]]);
}
(factors = $m.get(value, "friction_factors", $map([])));
(source = $or(origins__own_provenance(value, report), () => new Provenance()));
(made = $method($c8, "built", [value, report], [["factors", factors], ["source", source]]));
return $or(made, () => $call(Condition, [], [["name", $b.str($m.get(value, "name", "dry"))]]));
}
function drive__repeated(key, names) {
let found;

(found = $b.list(names));
if (($eq($b.len($b.set(found)), $b.len(found)))) {
return [];
}
return [...(function* () { for (const [name, count] of $iter($m.items($b.Counter(found)))) { if (!((count > 1))) continue; yield $call(Problem, [], [["key", ("" + $str(key) + ".name")], ["value", $shown(name)], ["message", ("" + "used " + $str(count) + " times")], ["remedy", "Give each its own name."]]); } })()];
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
$m.append(problems, $call(Problem, [], [["key", key], ["message", message], ["remedy", remedy]]));
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
return new InputError($call(Problem, [], [["message", message], ["remedy", remedy], ["value", $shown(given)]]));
}
function parse___no_unit(value, dimension) {
let kind, message;
(kind = $at($c12, dimension));
(message = ("" + "no unit, where " + $str(kind.name) + " is needed"));
return parse___refused(value, message, ("" + "Write the unit too, for example " + $str($shown($bound(kind, "example"))) + "."));
}
function parse___refused(given, message, remedy) {
return new InputError($call(Problem, [], [["message", message], ["remedy", remedy], ["value", $shown(given)]]));
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
(tensions = $call(tensions__resolve, [own, speed, report], [["sure", sure]]));
$m.append(built, $call(LoadCase, [], [["name", "design"], ["tensions", tensions]]));
}
for (case_ of $iter(cases)) {
if (($in("train", case_))) {
report.add([...$iter(case_.place), "train"], "there is no [train] table", "Write one.");
}
(given = drive_file___of_case(case_, own, take_up, speed, report));
(whole = $and(sure, () => case_.sound()));
(tensions = $call(tensions__resolve, [given, speed, report], [["sure", whole]]));
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
function tension_rules__pull_given(of, at) {

if ((of.effective_tension != null)) {
return of.effective_tension;
}
if ((of.torque != null)) {
return ((at.diameter == null) ? null : load_case__pull_of_torque($bound(of, "torque"), $bound(at, "diameter")));
}
if (((of.power == null) || (at.speed == null))) {
return null;
}
return load_case__pull_of_power($bound(of, "power"), $bound(at, "speed"));
}
function load_case__pull_of_torque(torque, diameter) {

return ($mul(2.0, torque) / diameter);
}
function load_case__pull_of_power(power, speed) {

return (power / speed);
}
function tension_rules__filled(entry, leaving, pull) {

if (((pull != null) && (leaving == null) && (entry != null))) {
return new NipTensions(entry, $sub(entry, pull));
}
if (((pull != null) && (entry == null) && (leaving != null))) {
return new NipTensions($add(leaving, pull), leaving);
}
return new NipTensions(entry, leaving);
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
function tension_rules__fault_of(of, inherited, at, force) {
let between, ends, given, message, pull, pulls, remedy;

([pulls, given] = [tension_rules__effective_keys(of), tension_rules__families(of)]);
if (!$truth(tension_rules__overdetermined(of))) {
return null;
}
if (($b.len(pulls) > 1)) {
return new LoadFault(("" + $str(tension_rules__listed(pulls)) + " each fix the effective tension"), "Leave one of them out.", "");
}
(message = ("" + $str(tension_rules__listed(given)) + " are given, and two of them fix the third"));
([pull, ends] = [tension_rules__pull_given(of, at), tension_rules__ends_of(of, at)]);
if (((pull != null) && (ends.entry != null) && (ends.exit != null))) {
(between = $sub(ends.entry, ends.exit));
if (($b.abs($sub(pull, between)) > $mul(1e-06, $b.abs(between)))) {
(message = ("" + $str(tension_rules__listed(given)) + " contradict each other: entry less exit tension is " + $str(force(between)) + ", " + $str($at(pulls, 0)) + " makes " + $str(force(pull))));
}
}
(remedy = "Give two of them in the load case: they replace those of the pulley.");
return new LoadFault(message, ($truth(inherited) ? remedy : "Leave one of them out."), "");
}
function tension_rules__effective_keys(of) {

return [...(function* () { for (const key of $iter($c34)) { if (!(($b.getattr(of, key) != null))) continue; yield key; } })()];
}
function tension_rules__families(of) {
let keys, pulls;

(keys = [...(function* () { for (const key of $iter($c35)) { if (!(($b.getattr(of, key) != null))) continue; yield key; } })()]);
(pulls = tension_rules__effective_keys(of));
if (($b.len(pulls) > 0)) {
$m.append(keys, $at(pulls, 0));
}
return keys;
}
function tension_rules__overdetermined(of) {

return $or(($b.len(tension_rules__effective_keys(of)) > 1), () => ($b.len(tension_rules__families(of)) > 2));
}
function tension_rules__listed(keys) {

return ("" + $str($m.join(", ", $slice(keys, null, $neg(1)))) + " and " + $str($at(keys, $neg(1))));
}
function tension_rules__ends_of(of, at) {

return tension_rules__filled($bound(of, "entry_tension"), $bound(of, "exit_tension"), tension_rules__pull_given(of, at));
}
function tension_rules__speed_missing(of, at) {
let remedy;

if (((at.speed != null) || (of.power == null))) {
return null;
}
(remedy = "Write speed = \"3 m/s\" in [belt], or give effective_tension.");
return new LoadFault("power needs the belt speed", remedy, "power");
}
function tensions___made(item, entry, exit_, report) {
let key, made, message, place, pulls, remedy, side, tension, told, what, why;
(pulls = tension_rules__effective_keys($bound(item, "values")));
try {
(told = $m.join(" and ", (function* () { for (const key of $iter(pulls)) { yield $m.strip(("" + $str($m.replace(key, "_", " ")) + " " + $str($m.get(item.raw, key, "")))); } })()));
(why = ($truth(told) ? ("" + "computed from " + $str(told)) : "that of the neighbouring pulley"));
(made = $map([...(function* () { for (const [key, name] of $iter($m.items($c36))) { if (!(($b.getattr($bound(item, "values"), name) == null))) continue; yield [key, why]; } })()]));
return $call(Tensions, [], [["entry", entry], ["exit", exit_], ["computed", made]]);
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
function tension_rules__too_few(of) {
let given, message;

(given = tension_rules__families(of));
if (($eq($b.len(given), 0))) {
return new LoadFault("no tensions are given", "Give two of entry_tension, exit_tension and one of effective_tension, torque, power.", "tensions");
}
(message = ("" + "only " + $str($at(given, 0)) + " is given, and it takes two quantities to fix the tensions"));
return new LoadFault(message, "Give two of entry_tension, exit_tension and one of effective_tension, torque, power.", "tensions");
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
(conveyor = $method($c37, "built", [given, report], [...more]));
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
for ([first, second, example] of $iter($c38)) {
if ((($in(first, given)) && ($in(second, given)))) {
(message = ("" + $str(first) + " and " + $str(second) + " both say the same"));
$m.append(problems, $call(Problem, [], [["key", second], ["message", message], ["remedy", "Leave one of them out."]]));
} else {
if (((!$eq(example, "")) && (!$in(first, given)) && (!$in(second, given)))) {
(remedy = ("" + "Write " + $str(example) + ", or " + $str(second) + "."));
$m.append(problems, $call(Problem, [], [["key", first], ["message", "missing"], ["remedy", remedy], ["code", "missing"]]));
}
}
}
for (key of $iter($c39)) {
if ((($in(key, given)) && (!$in("speed", given)))) {
(remedy = "Write speed = \"3 m/s\" in [belt].");
$m.append(problems, $call(Problem, [], [["key", key], ["message", "needs the belt speed"], ["remedy", remedy]]));
}
}
return problems;
}
function conveyor_build__load_case(state, pulley) {
let kind, made, tensions, why;

(why = "computed from the resistances of the conveyor");
(made = $map([["entry", why], ["exit", why]]));
(tensions = $call(Tensions, [], [["entry", state.entry], ["exit", state.exit], ["computed", made]]));
(kind = state.kind);
return $call(LoadCase, [], [["name", state.name], ["tensions", $map([[pulley, tensions]])], ["kind", kind]]);
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
return [$call(Problem, [], [["message", ("" + "the belt presses on no pulley: m v^2 = " + $str(display__display(force, "force")) + ", with a mass of " + $str(display__display($or(belt.mass, () => 0.0), "mass_per_length")) + ", and its least tension is " + $str(display__display(least, "force")))], ["remedy", "Give the mass of a metre of belt, not that of the whole belt."], ["key", key]])];
}
function pitch__centrifugal_of(belt) {

if (((belt.mass == null) || (belt.speed == null))) {
return 0.0;
}
return pitch__centrifugal_force($bound(belt, "mass"), $bound(belt, "speed"));
}
function pitch__centrifugal_force(mass, speed) {

return $mul($mul(mass, speed), speed);
}
function drive__side_problems(belt, pulleys) {

if ($truth($b.all((function* () { for (const key of $iter([...$iter($c6), "thickness"])) { yield ($b.getattr(belt, key) == null); } })()))) {
return [];
}
return [...(function* () { for (const pulley of $iter(pulleys)) { if (!((($eq(pulley.side, "carry")) && $truth($math.isnan(pitch__touching_cover(pitch__layers_of(belt), true)))))) continue; yield $call(Problem, [], [["message", "the pulley meets the carry side, and carry_cover of the belt is not given"], ["remedy", "Give carry_cover = \"5 mm\" in [belt], or thickness with the other layers."], ["key", ("" + "pulley." + $str(pulley.name) + ".side")], ["value", $shown($bound(pulley, "side"))]]); } })()];
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

(document = $call(overridden, [document, overrides], [["file", file]]));
if ((!$in("train", document))) {
(drive = $call(drive_file__drive_from_document, [document], [["file", file], ["folder", folder], ["allow_paths", allow_paths]]));
return Train.of(drive);
}
([record, report] = source__read_tables($c40, document, file));
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
(key = ($truth($m.fullmatch($c41, step)) ? step : $shown(step)));
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
return $call(Problem, [], [["message", message], ["remedy", remedy], ["value", value], ["file", file], ["line", line]]);
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
function errors___stopped(sentence) {
return ((!$truth(sentence) || ($in($at(sentence, $neg(1)), ".?!"))) ? sentence : $add(sentence, "."));
}
function problems___renamed(key, names) {
let name, path, place, position;

(place = []);
(path = []);
for ([name, position] of $iter($m.findall($c42, key))) {
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
(sources = origins__read_sources(record, $c43, report));
(common = $map([...(function* () { for (const key of $iter($c44)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
$put(common, "provenance", $or(origins__own_provenance(record, report), () => new Provenance()));
$put(common, "cost", $c45.built($m.get(record, "cost"), report));
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

(given = [...(function* () { for (const key of $iter($c46)) { if (!(($in(key, record)))) continue; yield key; } })()]);
if (!$truth(record.sound("thickness", ...$iter($c46)))) {
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
(stated = $map([...(function* () { for (const key of $iter($c47)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
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
(block = $method($c48, "built", [shape, report], [...height]));
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
function compression__block_modulus(elastic_modulus, square, width, height, k, contact) {
let s2;

(s2 = $pow(compression__shape_factor(square, width, height), 2));
if ($truth(square)) {
return $mul($mul(contact, elastic_modulus), $add(1.0, $mul($mul(2.0, k), s2)));
}
return $mul($mul($mul(contact, (4.0 / 3.0)), elastic_modulus), $add(1.0, $mul(k, s2)));
}
function compression__shape_factor(square, width, height) {

return (width / $mul(($truth(square) ? 4.0 : 2.0), height));
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
$put(found, $at(row, "condition"), $method($c49, "built", [row, report], [["source", source]]));
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
return $map([["law", ((factors != null) ? factors.used : tested)], ["factors", factors], ["condition", $m.get(law, "condition", "dry")], ["fit", $c56.built($m.get(law, "fit"), report)], ["notes", [...$iter(notes), ...$iter($m.get(law, "notes", []))]], ["sources", $merged(sources, $map([...(function* () { for (const [part, of] of $iter($m.items(parts))) { if (!($truth(of))) continue; yield [part, of]; } })()]))]]);
}
function laws__read_law(record, report) {
let error, kind, law, names;

if (!$truth(record.sound())) {
return null;
}
(kind = $at(record, "kind"));
(names = $merged($c50, $map([["pressure", $m.get($c51, kind, "tested_pressure")]])));
try {

if (($eq(kind, "integral-log"))) {
(law = laws___integral_log(record));
} else {
if (($eq(kind, "table"))) {
(law = laws___table(record));
} else {
(law = $method($c52, "built", [record, report], [["tested", laws___tested(record)]]));
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
return $call(TestedRange, [], [["pressure_min", $at(pressures, 0)], ["pressure_max", $at(pressures, 1)], ["slip_max", slip], ["slip_speed", speed]]);
}
function laws___problem(key, message, remedy = "", value = "") {
return new InputError($call(Problem, [], [["message", message], ["remedy", remedy], ["key", key], ["value", value]]));
}
function laws___table(record) {
let problems, rows, slips;
(rows = $at(record, "rows"));
laws___check_order(rows, "rows");
(slips = $b.len($at(record, "slip")));
(problems = [...(function* () { for (const [number, row] of $iter($b.enumerate(rows, $k({start: 1})))) { if (!((!$eq($b.len($at(row, "friction")), slips)))) continue; yield $call(Problem, [], [["key", ("" + "rows[" + $str(number) + "].friction")], ["message", ("" + $str($b.len($at(row, "friction"))) + " values for " + $str(slips) + " slips")], ["remedy", "Give one for each slip."]]); } })()]);
laws___raise(problems);
return $call(MeasuredTable, [], [["slip", $b.tuple($at(record, "slip"))], ["pressure", $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })())], ["values", $b.tuple((function* () { for (const row of $iter(rows)) { yield $b.tuple($at(row, "friction")); } })())]]);
}
function laws___check_order(rows, key) {
let problems;

(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($at(row, "pressure") <= $at(before, "pressure")))) continue; yield $call(Problem, [], [["key", ("" + $str(key) + "[" + $str(number) + "].pressure")], ["message", ("" + "not above the pressure of the row before, " + $str($shown($at(before.raw, "pressure"))))], ["remedy", "Write the rows in order of rising pressure."]]); } })()]);
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
return $call(IntegralLog, [], [["coefficients", coefficients], ["tested", tested]]);
}
function laws___pieces(record) {
let error, more, number, pieces, pressure_unit, problems, row, rows, slip_unit;
(slip_unit = laws___unit(record, "slip_unit", "length", "mm"));
(pressure_unit = laws___unit(record, "pressure_unit", "pressure", "kPa"));
(rows = $at(record, "pieces"));
(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($b.abs($sub(($at(row, "from") / $at(before, "to")), 1.0)) > 1e-09))) continue; yield $call(Problem, [], [["key", ("" + "pieces[" + $str(number) + "].from")], ["message", ("" + "not where the piece before ends, " + $str($shown($at(before.raw, "to"))))], ["remedy", "Let the pieces follow each other without gap or overlap."]]); } })()]);
(pieces = []);
for ([number, row] of $iter($b.enumerate(rows, $k({start: 1})))) {
try {
$m.append(pieces, laws___piece(row, slip_unit, pressure_unit));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield $call(Problem, [], [["message", p.message], ["remedy", p.remedy], ["key", ("" + "pieces[" + $str(number) + "]." + $str(p.key))]]); } })()]));
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
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield $call(Problem, [], [["message", p.message], ["remedy", p.remedy], ["key", key]]); } })()]));
} else throw $error;
}
}
laws___raise(problems);
return $call(Piece, [], [...trends]);
}
function laws___useless_slope(key) {
return $call(Problem, [], [["key", key], ["message", "missing, and without it friction stays at its peak, whatever the slope"], ["remedy", "Give the level that friction falls to."]]);
}
function trends__read_trend(text, pressure_unit = 1.0, factor = 1.0) {
let exponent, single, terms, trend;

(terms = trends___terms(text));
(single = (($eq($b.len(terms), 1)) ? $at(terms, 0) : null));
if (($truth(single) && (single.exponent != null))) {
(trend = trends___scaled_exponent($bound(single, "exponent"), $mul(single.coefficient, $b.Decimal(factor)), text));
} else {
if (($truth(single) && ($eq(single.function, "p")) && (!$in(single.power, [0, 1, 2, 3])))) {
(exponent = $call(Trend, [], [["form", "logarithmic"], ["coefficients", [0.0, single.power]]]));
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

return $c53;
}
const $kept_trends___grammar = new Map();
function trends___refused(text, message) {
return new InputError($call(Problem, [], [["message", message], ["remedy", "Write it over the pressure p as a polynomial (0.12 - 0.00021 p + 1.4e-7 p^2), a logarithm (-0.31 + 0.042 ln(p)), a power (-1.6 p^-0.45) or an exponential (-0.2 exp(-0.0031 p))."], ["value", $shown(text)]]));
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
return $call(Trend, [], [["form", form], ["coefficients", $b.tuple($slice(coefficients, null, count))]]);
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
return $call(Trend, [], [["form", form], ["coefficients", [first, ...$iter($slice(c, 1, null))]], ["sign", sign]]);
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
return $call(Trend, [], [["form", trend.form], ["coefficients", c], ["sign", trend.sign]]);
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
return $call(PressureKnots, [], [["pressure", $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })())], ["peak_friction", $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_friction"); } })())], ["peak_slip", $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_slip"); } })())], ["post_peak_slope", ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "post_peak_slope", 0.0); } })()) : [])], ["residual_friction", ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "residual_friction", $at(row, "peak_friction")); } })()) : [])]]);
}
function lagging_build___factors(tested, law, record, report) {
let found, key, made, source, table, tables;

(tables = $map([]));
for ([key, table] of $iter([["slip_speed", $c54], ["temperature", $c55]])) {
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
throw new InputError($call(Problem, [], [["file", ("" + "catalogue lagging " + $str(name))], ["key", "name"], ["value", $shown($at(record, "name"))], ["message", "is not the name of its file"], ["remedy", ("" + "Write name = " + $str($shown(name)) + ", or rename the file.")]]));
}
return record;
}
const $kept_lagging_file___catalogue_record = new Map();
function lagging_file___record(text, file) {
return lagging_file___checked_record(parsed(text, file), file);
}
function lagging_file___checked_record(document, file) {
let record, report;

([record, report] = source__read_tables($c57, document, file));
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

return new InputError((function* () { for (const problem of $iter(error.problems)) { yield (($truth(problem.key) || $truth(problem.line) || !$truth(problem.file)) ? problem : $call(Problem, [], [["message", ("" + $str(problem.file) + " " + $str(problem.message))], ["remedy", problem.remedy]])); } })());
}
function lagging_file__lagging_record(name_or_path, folder, allow_paths) {
let path, text;

if (!$truth(lagging_file__is_path(name_or_path))) {
(text = laggingText(name_or_path));
return [$once(lagging_file___catalogue_record, $kept_lagging_file___catalogue_record)(name_or_path, text), ("" + "catalogue lagging " + $str(name_or_path))];
}
if (!$truth(allow_paths)) {
throw new InputError($call(Problem, [], [["message", "the path of a file cannot be used here"], ["remedy", ("" + "Choose one of " + $str($m.join(", ", laggingNames())) + ", or put the lagging into the drive file as a [lagging.NAME] table.")], ["value", $shown(name_or_path)]]));
}
(path = readText(folder, name_or_path));
return [lagging_file___record(readText(path), path), path];
}
function drive_build___merged_origins(base, given) {
let own, provenance, sources;

(own = $or($m.get(given, "provenance"), () => drive_build___given_instead(given)));
(sources = $map([...(function* () { for (const [key, of] of $iter($m.items($m.get(base, "sources", $map([]))))) { if (!((!$in(key, given)))) continue; yield [key, of]; } })()]));
(sources = $merged(sources, $map([...(function* () { for (const key of $iter(given)) { if (!(($in(key, $c59)))) continue; yield [key, own]; } })()])));
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
$m.append(problems, $call(Problem, [], [["key", key], ["value", given], ["message", message]]));
}
}
return problems;
}
function conditions__design_ratio(standard, surface, condition, tested = "dry") {
let band, dry, here, high, known, low, note, source, there;

(there = [...(function* () { for (const d of $iter((() => $c60)())) { if (!((($eq(d.standard, standard)) && ($eq(d.surface, surface))))) continue; yield d; } })()]);
(here = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, condition)))) continue; yield d; } })(), null));
(dry = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, tested)))) continue; yield d; } })(), null));
if (((here == null) || (dry == null))) {
(known = $b.sorted(new Set((function* () { for (const d of $iter((() => $c60)())) { if (!($truth(d.condition))) continue; yield d.standard; } })())));
throw new InputError($call(Problem, [], [["key", ("" + "condition." + $str(condition))], ["value", $shown(standard)], ["message", ("" + "no design values of surface " + $str($shown(surface)) + " both " + $str(tested) + " and " + $str(condition))], ["remedy", ("" + $str($m.join(", ", known)) + " have dry, wet, and wet and dirty; or state a factor.")]]));
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

(values = (function* () { for (const d of $iter((() => $c60)())) { if (!((($eq(d.surface, surface)) && $truth(d.condition)))) continue; yield d; } })());
return $b.tuple($b.fromkeys((function* () { for (const d of $iter(values)) { yield d.condition; } })()));
}
function tension_rules__overridden(of, over, fixed, at, runs) {
let between, by, ends, half, pull;

if (($b.len(tension_rules__families(over)) >= 2)) {
return over;
}
(pull = tension_rules__pull_given(over, at));
if (($truth(fixed) && (pull != null) && ($eq($b.len(tension_rules__effective_keys(over)), 1)))) {
(ends = tension_rules__ends_of(tension_rules__less_runs(of, $bound(runs, "base"), at), at));
if (((ends.entry == null) || (ends.exit == null))) {
return over;
}
([half, between] = [$mul(0.5, $add(ends.entry, ends.exit)), $mul(0.5, $sub(pull, runs.case))]);
return new LoadGiven($add(half, between), $sub(half, between), null, null, null);
}
(by = (($b.len(tension_rules__effective_keys(over)) > 0) ? over : of));
return new LoadGiven(((over.entry_tension == null) ? of.entry_tension : over.entry_tension), ((over.exit_tension == null) ? of.exit_tension : over.exit_tension), $bound(by, "effective_tension"), $bound(by, "torque"), $bound(by, "power"));
}
function tension_rules__less_runs(of, runs, at) {
let pull;

(pull = tension_rules__pull_given(of, at));
if ((($eq(runs, 0.0)) || (pull == null))) {
return of;
}
return new LoadGiven($bound(of, "entry_tension"), $bound(of, "exit_tension"), $sub(pull, runs), null, null);
}
function load_case__exit_behind(entry, leaving) {

return (($b.abs($sub(entry, leaving)) <= $mul(1e-12, entry)) ? entry : leaving);
}
function criteria__choice_problems(thing, choices) {

return [...(function* () { for (const [key, words] of $iter($m.items(choices))) { if (!((!$in($b.getattr(thing, key), words)))) continue; yield $call(Problem, [], [["key", key], ["value", $shown($b.getattr(thing, key))], ["message", ("" + "must be one of " + $str($m.join(", ", (function* () { for (const word of $iter(words)) { if (!($truth(word))) continue; yield word; } })())))]]); } })()];
}
function limits__name_problems(key, name) {
let message;

if (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($b.len(name) <= 60) && $truth($m.isprintable(name)))) {
return [];
}
(message = "must be a printable text of 1 to 60 characters");
return [$call(Problem, [], [["key", key], ["value", $shown(name)], ["message", message]])];
}
function drive___wrong_pulleys(case_, names) {
let missing, parts, unknown;
([missing, unknown] = [$b.sorted($sub(names, $m.keys(case_.tensions))), $b.sorted($sub($m.keys(case_.tensions), names))]);
(parts = ($truth(missing) ? [("" + "no tensions for " + $str($shown(missing)))] : []));
(parts = $add(parts, ($truth(unknown) ? [("" + "tensions for " + $str($shown(unknown)) + ", which the drive does not have")] : [])));
return $call(Problem, [], [["key", ("" + "load_case." + $str(case_.name))], ["message", $m.join(" and ", parts)]]);
}
function drive__condition_problems(case_, condition, pulleys) {

return [...(function* () { for (const p of $iter(pulleys)) { if (!(($truth(condition) && (!$in(condition, (function* () { for (const lagging of $iter(p.conditions)) { yield lagging.condition; } })()))))) continue; yield $call(Problem, [], [["key", ("" + "load_case." + $str(case_) + ".condition")], ["value", $shown(condition)], ["message", ("" + "pulley " + $str($shown($bound(p, "name"))) + " does not say its lagging in this condition")]]); } })()];
}
function train___count_problems(key, values, count) {
let message;
if (($eq($b.len(values), count))) {
return [];
}
(message = ("" + "must have one value for each of the " + $str(count) + " pulleys"));
return [$call(Problem, [], [["key", key], ["value", ("" + $str($b.len(values)) + " values")], ["message", message]])];
}
function train___case_problems(case_, names) {
let count, division, given, message, problems, speeds, where;

([where, count] = [("" + "load_case." + $str(case_.name)), $b.len(names)]);
(problems = []);
if (($truth(case_.runs) && (!$eq($b.len($bound(case_, "runs")), $sub(count, 1))))) {
(message = ("" + "must have one value for each of the " + $str($sub(count, 1)) + " runs between pulleys"));
(given = ("" + $str($b.len($bound(case_, "runs"))) + " values"));
$m.append(problems, $call(Problem, [], [["key", ("" + $str(where) + ".run")], ["value", given], ["message", message]]));
} else {
if (!$truth($b.all($b.map($math.isfinite, $bound(case_, "runs"))))) {
$m.append(problems, $call(Problem, [], [["key", ("" + $str(where) + ".run")], ["message", "must be finite"]]));
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
$m.append(problems, $call(Problem, [], [["key", ("" + $str(where) + ".speeds")], ["message", message]]));
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
$m.append(problems, $call(Problem, [], [["key", key], ["value", ("" + "[" + $str(given) + "]")], ["message", message], ["remedy", remedy]]));
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
return [$call(Problem, [], [["key", key], ["message", message], ["remedy", remedy]])];
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
(message = ("" + "the pulleys together pull " + $str($call(display__display, [total, "force"], [["digits", 6]])) + ", and the tensions at both ends ask for " + $str($call(display__display, [asked, "force"], [["digits", 6]]))));
$m.append(problems, $call(Problem, [], [["key", key], ["message", message]]));
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
$m.append(problems, $call(Problem, [], [["key", where], ["value", $shown($bound(motor, "master"))], ["message", message]]));
} else {
if ($truth($b.isinstance(leads, TorqueFollower))) {
(message = "the drive that is followed must not follow another one itself");
$m.append(problems, $call(Problem, [], [["key", where], ["value", $shown($bound(motor, "master"))], ["message", message]]));
}
}
}
if (($eq($at($b.Counter($b.map($b.type, motors)), TorqueFollower), $b.len(motors)))) {
(message = "every drive follows another one: one must hold the speed");
$m.append(problems, $call(Problem, [], [["key", key], ["message", message]]));
}
return problems;
}
function train___case_of(drive, case_) {
let pairs, runs;
(pairs = [...(function* () { for (const p of $iter(drive.pulleys)) { yield $at(case_.tensions, p.name); } })()]);
(runs = $b.tuple((function* () { for (const [a, b] of $iter($b.pairwise(pairs))) { yield $sub(b.entry, a.exit); } })()));
return $call(TrainCase, [], [["name", case_.name], ["entry_tension", $at(pairs, 0).entry], ["exit_tension", $at(pairs, $neg(1)).exit], ["division", new Pulls($b.tuple((function* () { for (const pair of $iter(pairs)) { yield pair.effective; } })()))], ["runs", ($truth($b.any(runs)) ? runs : [])], ["kind", case_.kind], ["condition", case_.condition]]);
}
function tension_rules__behind_take_up(now, first, after, before) {
let lost, pull, pull_0;

if (((now.entry == null) || (now.exit == null) || (first.entry == null) || (first.exit == null))) {
return null;
}
([pull, pull_0] = [$sub(now.entry, now.exit), $sub(first.entry, first.exit)]);
(lost = $sub($mul(after.share, $add(pull, after.runs)), after.behind));
(lost = $sub(lost, $sub($mul(before.share, $add(pull_0, before.runs)), before.behind)));
return new NipTensions($add($sub(first.exit, lost), pull), $sub(first.exit, lost));
}
function base__check(...tests) {
let failed;

(failed = [...(function* () { for (const [passed, key, value, message] of $iter(tests)) { if (!(!$truth(passed))) continue; yield $call(Problem, [], [["key", key], ["value", value], ["message", message]]); } })()]);
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
return [$call(Problem, [], [["key", key], ["value", display__display(value, dimension)], ["message", message], ["remedy", remedy]])];
}
([low, high] = [(($eq(key, "slip_speed")) ? 0.0 : $at(table.at, 0)), $at(table.at, $neg(1))]);
if ((low <= value && value <= high)) {
return [];
}
(ends = ("" + $str(display__display($at(table.at, 0), dimension)) + " to " + $str(display__display(high, dimension))));
(message = ("" + "outside the " + $str(ends) + " that its factor is known for"));
return [$call(Problem, [], [["key", key], ["value", display__display(value, dimension)], ["message", message], ["remedy", "Test the lagging there, and add the factor to its table."]])];
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
function tables__need(key, meaning = "", kind = $c601, more = new Map()) {

return $replaced($call(Entry, [key, meaning, kind], [...more]), new Map([["required", true]]));
}
function resistance__no_coefficient(length) {
let least;

if (!$truth($math.isnan(resistance__coefficient_at(length)))) {
return [];
}
(least = $at($at($c605, 0), 0));
return [$call(Problem, [], [["key", "length"], ["value", display__display(length, "length")], ["message", ("" + "is below " + $format(least, ("" + "g")) + " m, where no coefficient C is tabulated")], ["remedy", "Give secondary_resistance, or a length_coefficient of your own."]])];
}
function resistance__coefficient_at(length) {
let end, found, high, low, start;

(found = ((length < $at($at($c605, 0), 0)) ? NaN : $at($at($c605, $neg(1)), 1)));
for ([[start, high], [end, low]] of $iter($b.pairwise($c605))) {
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
return $call(Problem, [], [["key", "take_up_tension"], ["message", message], ["remedy", remedy]]);
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
$init(message, remedy = "", file = "", key = "", value = "", line = null, code = "") { this.message = message; this.remedy = remedy; this.file = file; this.key = key; this.value = value; this.line = line; this.code = code;  }
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
add(place, message, remedy = "", value = $c7, code = "") {
const self = this; let given, key;

if ($truth(self.full)) {
(self._left_out = $add(self._left_out, 1));
return null;
}
(given = ((value === $c7) ? "" : $shown(value)));
(code = (($eq(message, "missing")) ? "missing" : code));
(key = problems__place_text(place));
self._append($call(Problem, [], [["message", message], ["remedy", remedy], ["key", key], ["value", given], ["code", code]]));
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
$m.append(self.problems, $call(Problem, [], [["message", message], ["file", self.file]]));
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
throw new InputError($call(Problem, [], [["message", "a published number without a source"], ["remedy", "Name the publication, or call the number given or illustrative."]]));
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
for (group of $iter($c58)) {
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
return [...(function* () { for (const [key, factor] of $iter($m.items(factors))) { if (!(((factor != null) && (factor > 1.0)))) continue; yield $call(Problem, [], [["key", key], ["value", ("" + $format(factor, ("" + "g")))], ["message", message], ["remedy", remedy]]); } })()];
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

(tables = $b.fromkeys((function* () { for (const d of $iter((() => $c60)())) { if (!($truth(d.condition))) continue; yield d.standard; } })()));
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
return $call(Problem, [], [["key", ("" + "condition." + $str(self.name))], ["message", ("" + "lagging " + $str($shown($bound(lagging, "name"))) + " was tested " + $str(lagging.condition) + ", and nothing is published on its friction when " + $str(self.name) + " (covered: " + $str(covered) + ")")], ["remedy", $m.join(" ", (function* () { for (const part of $iter([errors__nearest($bound(self, "name"), known), ("" + "Give what it leaves of the friction, condition = { name = " + $str(name) + ", friction_factor = 0.8 }, or add a law for it to the lagging.")])) { if (!($truth(part))) continue; yield part; } })())]]);
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
$init(factor, powers, zero = $c66) { this.factor = factor; this.powers = powers; this.zero = zero;  }
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
$m.append(problems, $call(Problem, [], [["key", "rows"], ["value", $b.str($b.len($bound(self, "position")))], ["message", message]]));
} else {
if (($eq($b.len($bound(self, "position")), 1))) {
(message = "one row alone makes no profile");
$m.append(problems, $call(Problem, [], [["key", "rows"], ["message", message], ["remedy", "Give two rows or more."]]));
}
}
(wrong = [...(function* () { for (const [a, b] of $iter($b.pairwise($bound(self, "position")))) { if (!((b <= a))) continue; yield b; } })()]);
if ($truth(wrong)) {
$m.append(problems, $call(Problem, [], [["key", "rows"], ["value", display__display($at(wrong, 0), "length")], ["message", "the positions must ascend from one edge of the belt to the other"], ["remedy", "Sort the rows by position, the middle of the belt being 0."]]));
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
return [$call(Problem, [], [["key", key], ["value", display__display($at(beyond, 0), "length")], ["message", ("" + "beyond the belt, which reaches from " + $str(display__display($mul($neg(0.5), width), "length")) + " to " + $str(display__display($mul(0.5, width), "length")))], ["remedy", "Give positions from the middle of the belt, and leave out rows beside it."]])];
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
overridden(record, fixed = false, speed = null, runs = $c61) {
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
class LoadFault extends $Object {
$init(message, remedy, lacks) { this.message = message; this.remedy = remedy; this.lacks = lacks;  }
*[Symbol.iterator]() { yield this.message; yield this.remedy; yield this.lacks; }
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
(problems = criteria__choice_problems(self, $map([["kind", $c62]])));
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
$m.append(problems, $call(Problem, [], [["key", "pulley"], ["value", $b.str($b.len($bound(self, "pulleys")))], ["message", message]]));
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
$m.append(problems, $call(Problem, [], [["message", ("" + "the belt of [conveyor] has belt_mass = " + $str(other))], ["remedy", "Both are the mass of a metre of belt: give one, or the same twice."], ["key", "belt.mass"], ["value", display__display(mass, "mass_per_length")]]));
}
for ([key, least] of $iter($m.items(drive__least_tensions($bound(self, "load_cases"))))) {
(problems = $add(problems, drive__flying_problems($bound(self, "belt"), key, least)));
}
return problems;
}
get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.load_cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
}
take_up_tension(case_) {
const self = this; let after;

(after = self.criteria.take_up.after);
return ($truth(after) ? $at(case_.tensions, after).exit : self.slack_end(case_));
}
slack_end(case_) {
const self = this; let first, last, pull;

([first, last] = (function* () { for (const p of $iter([$at(self.pulleys, 0), $at(self.pulleys, $neg(1))])) { yield $at(case_.tensions, p.name); } })());
(pull = $math.fsum((function* () { for (const t of $iter($m.values(case_.tensions))) { yield t.effective; } })()));
return ((pull >= 0.0) ? last.exit : first.entry);
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
$m.append(problems, $call(Problem, [], [["key", "pulley"], ["value", $b.str(count)], ["message", message]]));
}
(problems = $add(problems, drive__repeated("pulley", (function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })())));
(problems = $add(problems, drive__repeated("load_case", (function* () { for (const c of $iter(self.cases)) { yield c.name; } })())));
(problems = $add(problems, self.criteria.take_up.place_problems([...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()])));
if (!$truth(self.cases)) {
$m.append(problems, $call(Problem, [], [["key", "load_case"], ["message", "a train needs a load case"]]));
}
if ($truth(self.nominal_diameters)) {
(problems = $add(problems, train___count_problems("nominal_diameters", $bound(self, "nominal_diameters"), count)));
if (!$truth($b.all((function* () { for (const d of $iter(self.nominal_diameters)) { yield (0.0 < d && d < Infinity); } })()))) {
(message = "must be positive and finite");
(given = $b.str($b.list($bound(self, "nominal_diameters"))));
$m.append(problems, $call(Problem, [], [["key", "nominal_diameters"], ["value", given], ["message", message]]));
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

get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
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
return $call(TrainCase, [], [["name", name], ["entry_tension", tensions.entry], ["exit_tension", tensions.exit], ["division", division], ["runs", ($truth($b.any(runs)) ? runs : [])]]);
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
([runs, fixed] = [$c61, self._take_up.fixed]);
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
if (((division == null) || !$truth($b.any((function* () { for (const key of $iter([...$iter($c34), ...$iter($c63), "run"])) { yield ($in(key, over)); } })())))) {
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
if (((over != null) && $truth($b.any((function* () { for (const mode of $iter($c63)) { yield ($in(mode, over)); } })())))) {
(record = over);
}
(modes = [...(function* () { for (const mode of $iter($c63)) { if (!(($in(mode, record)))) continue; yield mode; } })()]);
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
return $call(Speeds, [$b.tuple(values)], [["absolute", true]]);
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
(remedy = ("" + "Write [train.motor." + $str(name) + "] with kind = \"" + $str($b.next($b.iter($c64))) + "\"."));
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
(motor = $c65.built(record, $bound(self, "_report")));
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
class OfBelt extends $Dict {
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

_scaled(friction, slip) {
const self = this; let rows;
(rows = $b.tuple((function* () { for (const row of $iter(self.values)) { yield $b.tuple((function* () { for (const mu of $iter(row)) { yield $mul(mu, friction); } })()); } })()));
return $replaced(self, new Map([["slip", $b.tuple((function* () { for (const x of $iter(self.slip)) { yield $mul(x, slip); } })())], ["values", rows]]));
}
get tested() {
const self = this; 
return $call(TestedRange, [], [["pressure_min", $at(self.pressure, 0)], ["pressure_max", $at(self.pressure, $neg(1))], ["slip_max", $at(self.slip, $neg(1))]]);
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
base__check([($in(self.form, $c596)), "form", self.form, ("" + "the form must be one of " + $str($m.join(", ", $c596)))], [(1 <= n && n <= 4), "coefficients", $b.str(n), "one to four coefficients are needed"], [$b.all($b.map($math.isfinite, $bound(self, "coefficients"))), "coefficients", $b.str($bound(self, "coefficients")), "must be finite"], [($in(self.sign, [1, $neg(1)])), "sign", $b.str($bound(self, "sign")), "the sign must be 1 or -1"]);
}
at(pressure) {
const self = this; let c, exponential, logarithmic, v, y;

([logarithmic, exponential] = $at($c596, self.form));
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
}
class Piece extends $Object {
$init(a, b, post_peak_slope = $c67, residual_friction = $c68) { this.a = a; this.b = b; this.post_peak_slope = post_peak_slope; this.residual_friction = residual_friction;  }
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
$m.append(bad, $call(Problem, [], [["key", ("" + $str(key) + ".a")], ["value", ("" + $format(worst, ("" + "g")) + " 1/m")], ["message", ("" + "A must be negative " + $str(where) + ", else the law gives no positive friction")]]));
} else {
if (!$truth($b.all((function* () { for (const [u, v] of $iter($b.zip(a, b, $k({strict: true})))) { yield $and((-700.0 <= $sub((v / u), 1.0) && $sub((v / u), 1.0) < 709.0), () => (1e-09 <= $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) && $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) <= 1000.0)); } })()))) {
$m.append(bad, $call(Problem, [], [["key", ("" + $str(key) + ".b")], ["value", ("" + $format($at(b, 0), ("" + "g")) + " 1/m")], ["message", ("" + "the slip at the peak exp(b/A - 1) must be 1 nm to 1 km " + $str(where))]]));
}
}
if (!$truth($b.all((function* () { for (const v of $iter(slope)) { yield (v <= 0.0); } })()))) {
$m.append(bad, $call(Problem, [], [["key", ("" + $str(key) + ".post_peak_slope")], ["value", ("" + $format($b.max(slope), ("" + "g")) + " 1/m")], ["message", ("" + "the slope past the peak must be 0 or negative " + $str(where))]]));
}
if (!$truth($b.all((function* () { for (const v of $iter(residual)) { yield (v >= 1e-06); } })()))) {
$m.append(bad, $call(Problem, [], [["key", ("" + $str(key) + ".residual_friction")], ["value", ("" + $format($b.min(residual), ("" + "g")))], ["message", ("" + "residual friction must be at least " + $format(1e-06, ("" + "g")) + " " + $str(where))]]));
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
$m.append(bad, $call(Problem, [], [["key", ("" + "pieces[" + $str($add(i, 2)) + "]")], ["value", ("" + $format(u, ("" + "g")) + " and " + $format(v, ("" + "g")))], ["message", ("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %")]]));
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
return [...(function* () { for (const [name, key, pair, unit, of, jump] of $iter([["the slope past the peak", "post_peak_slope", slopes, " 1/m", " of the peak friction over a peak slip", apart], ["residual friction", "residual_friction", levels, "", "", $b.abs($sub(lower, 1.0))]])) { if (!((jump > self.continuity))) continue; yield $call(Problem, [], [["key", ("" + "pieces[" + $str($add(i, 2)) + "]." + $str(key))], ["value", ("" + $format($at(pair, 0), ("" + "g")) + " and " + $format($at(pair, 1), ("" + "g")) + $str(unit))], ["message", ("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %" + $str(of))]]); } })()];
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
if (($truth(self.surface) && (!$in(self.surface, $c597)))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c597))));
$m.append(problems, $call(Problem, [], [["key", "surface"], ["value", $shown($bound(self, "surface"))], ["message", message]]));
}
limits__raise_all(problems);
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
class Pulls extends $Object {
$init(effective_tensions) { this.effective_tensions = effective_tensions;  }
}
class Speeds extends $Object {
$init(rotation_speeds, absolute = false) { this.rotation_speeds = rotation_speeds; this.absolute = absolute;  }
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
class Motors extends $Object {
$init(motors) { this.motors = motors;  }
}
class TakeUp extends $Object {
$init(kind = "", sheave_ratio = 2.0, after = "") { this.kind = kind; this.sheave_ratio = sheave_ratio; this.after = after; this.__post_init__?.(); }
__post_init__() {
const self = this; let given, message, problems, remedy;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, criteria__choice_problems(self, $map([["kind", ["", ...$iter($c598)]]]))));
if (($truth(self.after) && $truth(self.fixed))) {
(message = "a fixed take-up holds the sum of both tensions wherever it stands");
(remedy = "Leave it out, or correct the kind.");
(given = $shown($bound(self, "after")));
$m.append(problems, $call(Problem, [], [["key", "after"], ["value", given], ["message", message], ["remedy", remedy]]));
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
return [$call(Problem, [], [["key", "take_up.after"], ["value", given], ["message", message], ["remedy", remedy]])];
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
(words = $map([["name", ["", ...$iter($c599)]], ["condition", ["", ...$iter($c600)]]]));
(problems = $add(limits__limit_problems(self, $bound(self, "LIMITS")), criteria__choice_problems(self, words)));
if ((!$eq(($eq(self.name, "own")), (self.friction != null)))) {
(given = ((self.friction == null) ? "" : ("" + $format(self.friction, ("" + "g")))));
(message = "missing, where the standard is your own");
(remedy = "Write friction = 0.30 beside it.");
if ($truth(given)) {
([message, remedy] = ["only a standard of your own has one", "Write name = \"own\"."]);
}
$m.append(problems, $call(Problem, [], [["key", "friction"], ["value", given], ["message", message], ["remedy", remedy]]));
}
if ((($eq(self.name, "none")) && $truth(self.binding))) {
(message = "no standard was chosen that could bind");
$m.append(problems, $call(Problem, [], [["key", "binding"], ["value", "true"], ["message", message]]));
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
class Table extends Kind {
$init(title, of = null, on_one_line = false, ...entries) {
const self = this; ([self.title, self.of, self.on_one_line] = [title, of, on_one_line]);
(self.entries = $b.tuple((function* () { for (const e of $iter(entries)) { yield ((e.kind === $c601) ? $replaced(e, new Map([["kind", tables___kind_of(of, $bound(e, "attribute"))]])) : e); } })()));
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
get _fields() {
const self = this; 
return ($truth(self.of) ? $b.frozenset((function* () { for (const f of $iter($fields(self.of))) { yield f.name; } })()) : $b.frozenset());
}
}
class Entry extends $Object {
$init(key, meaning = "", kind = $c601, title = "", required = false, alias = "", example = "", attribute = "", unless = "", stated = false) { this.key = key; this.meaning = meaning; this.kind = kind; this.title = title; this.required = required; this.alias = alias; this.example = example; this.attribute = attribute; this.unless = unless; this.stated = stated; this.__post_init__?.(); }
__post_init__() {
const self = this; (self.title = $or(self.title, () => $m.replace(self.key, "_", " ").capitalize()));
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
if (!$truth($m.isprintable(($truth(self.lines) ? $m.translate(raw, $c602) : raw)))) {
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
const self = this; return $call(display__display, [bound, $bound(self, "dimension")], [["digits", 3]]);
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
return [$call(Problem, [], [["message", message], ["remedy", remedy], ["key", key]])];
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
$m.append(problems, $call(Problem, [], [["key", "strips"], ["value", $b.str($bound(self, "strips"))], ["message", message]]));
}
for (key of $iter(["worn_depth", "build_up"])) {
(profile = $b.getattr(self, key));
if (((profile != null) && ($b.min([...$iter(profile.value), profile.crown]) < 0.0))) {
(least = display__display($b.min([...$iter(profile.value), profile.crown]), "length"));
(message = "must not be negative");
$m.append(problems, $call(Problem, [], [["key", key], ["value", least], ["message", message]]));
}
}
limits__raise_all(problems);
}
problems(key, width) {
const self = this; let found;

(found = [...(function* () { for (const [name, profile] of $iter($m.items(self.profiles()))) { for (const problem of $iter(profile.problems(("" + $str(key) + "." + $str(name)), width))) { yield problem; }} })()]);
if (($truth($b.isinstance(self.before, Transition)) && (self.before.centre_roll >= width))) {
$m.append(found, $call(Problem, [], [["key", ("" + $str(key) + ".before.centre_roll")], ["value", display__display($bound(self.before, "centre_roll"), "length")], ["message", ("" + "wider than the belt, " + $str(display__display(width, "length")))], ["remedy", "Give the width of belt on the centre roll."]]));
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
$init(names, factor, unit, zero = $c608) { this.names = names; this.factor = factor; this.unit = unit; this.zero = zero;  }
*[Symbol.iterator]() { yield this.names; yield this.factor; yield this.unit; yield this.zero; }
}
class Variant extends Kind {
$init(tag, meaning, ...tables) {
const self = this; (self.tag = tag);
(self.tables = $map([...(function* () { for (const t of $iter(tables)) { yield [t.title, $call(Table, [$bound(t, "title"), tables__need(tag, meaning, new Choice([t.title])), ...$iter(t.entries)], [["of", t.of]])]; } })()]));
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
(problems = $add(problems, criteria__choice_problems(self, $map([["side", $c603]]))));
(worn = ($truth(self.across) ? self.across.worn_depth : null));
if (((worn != null) && (worn.largest >= self.lagging.thickness))) {
$m.append(problems, $call(Problem, [], [["key", "across.worn_depth"], ["value", display__display($bound(worn, "largest"), "length")], ["message", $add("deeper than the lagging is thick, ", display__display($bound(self.lagging, "thickness"), "length"))], ["remedy", "Give the depth worn off, on radius, not what is left."]]));
}
limits__raise_all(problems);
}
}
class Sag extends $Object {
$init(spacing, line_mass, share = 0.02) { this.spacing = spacing; this.line_mass = line_mass; this.share = share; this.__post_init__?.(); }
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
class Conveyor extends $Object {
$init(length, lift = 0.0, belt_mass, carry_idler_mass, return_idler_mass, material_mass = null, capacity = null, friction_factor = 0.02, length_coefficient = null, secondary_resistance = null, special_resistance = 0.0, return_share = 0.0, start_factor = null, start_time = null, stop_time = null, take_up_tension = null, counterweight = null, take_up_distance = 0.0, drive_at = "head", speed = null, sheave_ratio = 2.0) { this.length = length; this.lift = lift; this.belt_mass = belt_mass; this.carry_idler_mass = carry_idler_mass; this.return_idler_mass = return_idler_mass; this.material_mass = material_mass; this.capacity = capacity; this.friction_factor = friction_factor; this.length_coefficient = length_coefficient; this.secondary_resistance = secondary_resistance; this.special_resistance = special_resistance; this.return_share = return_share; this.start_factor = start_factor; this.start_time = start_time; this.stop_time = stop_time; this.take_up_tension = take_up_tension; this.counterweight = counterweight; this.take_up_distance = take_up_distance; this.drive_at = drive_at; this.speed = speed; this.sheave_ratio = sheave_ratio; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, conveyor__choices(new Set((function* () { for (const key of $iter(self.LIMITS)) { if (!(($b.getattr(self, key) != null))) continue; yield key; } })()))));
if ((!$in(self.drive_at, $c604))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c604))));
$m.append(problems, $call(Problem, [], [["key", "drive_at"], ["value", $shown($bound(self, "drive_at"))], ["message", message]]));
}
limits__raise_all($or(problems, () => $b.list(self.misfits())));
}
*misfits() {
const self = this; let given, long, message;

(long = display__display($bound(self, "length"), "length"));
if (($b.abs($bound(self, "lift")) >= self.length)) {
(given = display__display($bound(self, "lift"), "length"));
yield $call(Problem, [], [["key", "lift"], ["value", given], ["message", ("" + "must be less than the length, " + $str(long))]]);
}
if ((self.take_up_distance > self.length)) {
(given = display__display($bound(self, "take_up_distance"), "length"));
(message = ("" + "is more than the length, " + $str(long) + ", which is the tail"));
yield $call(Problem, [], [["key", "take_up_distance"], ["value", given], ["message", message]]);
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
$m.append(problems, $call(Problem, [], [["key", "start_factor"], ["message", message], ["remedy", remedy]]));
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
([least, most] = $c1277);
if ((least <= self.friction_factor && self.friction_factor <= most)) {
return "";
}
return ("" + ", outside the usual " + $format(least, ("" + ".3f")) + " to " + $format(most, ("" + ".3f")));
}
}
class Cost extends $Object {
$init(material, installation, currency, area, life_years) { this.material = material; this.installation = installation; this.currency = currency; this.area = area; this.life_years = life_years; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems, years;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(years = self.life_years);
if (!(0.0 < $at(years, 0) && $at(years, 0) <= $at(years, 1) && $at(years, 1) < Infinity)) {
(message = "must be the shortest and the longest life in years, both more than 0");
$m.append(problems, $call(Problem, [], [["key", "life_years"], ["value", $shown($b.list(years))], ["message", message]]));
}
limits__raise_all(problems);
}
}
class Block extends $Object {
$init(shape = "square", width, height, stiffening = 0.54, contact_fraction = 1.0) { this.shape = shape; this.width = width; this.height = height; this.stiffening = stiffening; this.contact_fraction = contact_fraction; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.shape, $c606))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c606))));
$m.append(problems, $call(Problem, [], [["key", "shape"], ["value", $shown($bound(self, "shape"))], ["message", message]]));
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
$m.append(problems, $call(Problem, [], [["key", "factor"], ["value", count], ["message", message]]));
}
if ($truth($b.any((function* () { for (const [before, after] of $iter($b.pairwise($bound(self, "at")))) { yield (after <= before); } })()))) {
$m.append(problems, $call(Problem, [], [["key", "at"], ["value", $shown($b.list($bound(self, "at")))], ["message", "must ascend"]]));
}
(bad = [...(function* () { for (const v of $iter(self.factor)) { if (!(!(0.0 < v && v <= 10.0))) continue; yield v; } })()]);
if ($truth(bad)) {
(message = "must be more than 0 and at most 10");
$m.append(problems, $call(Problem, [], [["key", "factor"], ["value", $shown($at(bad, 0))], ["message", message]]));
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
__post_init__() {
const self = this; let message, n, problems;
(n = $b.len($bound(self, "parameters")));
(problems = limits__limit_problems(self, $c607));
if ((($b.len($b.set($bound(self, "parameters"))) < n) || !$truth(n))) {
(message = "must name each fitted parameter once");
$m.append(problems, $call(Problem, [], [["key", "parameters"], ["value", $b.str(n)], ["message", message]]));
}
if (((!$eq($b.len($bound(self, "values")), n)) || !$truth($b.all($b.map($math.isfinite, $bound(self, "values")))))) {
(message = ("" + "must be " + $str(n) + " finite numbers, one for each parameter"));
$m.append(problems, $call(Problem, [], [["key", "values"], ["value", $b.str($b.len($bound(self, "values")))], ["message", message]]));
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
return [$call(Problem, [], [["key", "covariance"], ["value", given], ["message", message]])];
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
return ($truth(message) ? [$call(Problem, [], [["key", "covariance"], ["message", message]])] : []);
}
}
class DesignFriction extends $Object {
$init(standard, surface, condition, friction, provenance) { this.standard = standard; this.surface = surface; this.condition = condition; this.friction = friction; this.provenance = provenance;  }
}
class Motor extends $Object {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$eq(self.count, $b.int($bound(self, "count"))))) {
(message = "must be a whole number of motors");
$m.append(problems, $call(Problem, [], [["key", "count"], ["value", ("" + $format(self.count, ("" + "g")))], ["message", message]]));
}
limits__raise_all($add(problems, self._problems()));
}
_problems() {
const self = this; 
return [];
}
}
class VariableSpeed extends Motor {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, setting = 1.0, droop = 0.0, torque_limit = Infinity) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.setting = setting; this.droop = droop; this.torque_limit = torque_limit; this.__post_init__?.(); }
}
class Induction extends Motor {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, synchronous_speed, breakdown_ratio = 2.5) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.synchronous_speed = synchronous_speed; this.breakdown_ratio = breakdown_ratio; this.__post_init__?.(); }
_problems() {
const self = this; let message;
if (($mul(0.8, self.synchronous_speed) <= self.rated_speed && self.rated_speed < self.synchronous_speed)) {
return [];
}
(message = ("" + "must be below the synchronous speed " + $str(motors___rpm($bound(self, "synchronous_speed"))) + " by at most 20 %"));
return [$call(Problem, [], [["key", "rated_speed"], ["value", motors___rpm($bound(self, "rated_speed"))], ["message", message]])];
}
}
class FluidCoupling extends Induction {
$init(rated_power, rated_speed, gear_ratio = 1.0, gear_efficiency = 1.0, motor_efficiency = null, count = 1, brakes = true, synchronous_speed, breakdown_ratio = 2.5, coupling_load, coupling_slip) { this.rated_power = rated_power; this.rated_speed = rated_speed; this.gear_ratio = gear_ratio; this.gear_efficiency = gear_efficiency; this.motor_efficiency = motor_efficiency; this.count = count; this.brakes = brakes; this.synchronous_speed = synchronous_speed; this.breakdown_ratio = breakdown_ratio; this.coupling_load = coupling_load; this.coupling_slip = coupling_slip; this.__post_init__?.(); }
_problems() {
const self = this; let count, key, loads, message, problems, rising, slips, top, values;
(problems = super._problems());
([loads, slips] = [self.coupling_load, self.coupling_slip]);
if (((!$eq($b.len(loads), $b.len(slips))) || ($b.len(loads) < 2))) {
(count = ("" + $str($b.len(loads)) + " and " + $str($b.len(slips))));
(message = "the curve needs as many torques as slips, two or more of each");
$m.append(problems, $call(Problem, [], [["key", "coupling_slip"], ["value", count], ["message", message]]));
}
for ([key, values, top] of $iter([["coupling_load", loads, 10.0], ["coupling_slip", slips, 0.9]])) {
(rising = $b.all((function* () { for (const [a, b] of $iter($b.pairwise(values))) { yield (a < b); } })()));
if (!($truth(values) && ($eq($at(values, 0), 0.0)) && $truth(rising) && ($at(values, $neg(1)) <= top))) {
(message = ("" + "must rise from 0 to at most " + $format(top, ("" + "g"))));
$m.append(problems, $call(Problem, [], [["key", key], ["value", $b.str($b.list(values))], ["message", message]]));
}
}
return problems;
}
}
class Transition extends $Object {
$init(length, trough_angle, centre_roll, depth = "full") { this.length = length; this.trough_angle = trough_angle; this.centre_roll = centre_roll; this.depth = depth; this.__post_init__?.(); }
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.depth, $c969))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c969))));
$m.append(problems, $call(Problem, [], [["key", "depth"], ["value", $shown($bound(self, "depth"))], ["message", message]]));
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

_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
class Profile extends Kind {
$init(dimension, diameters = false) {
const self = this; let entries, words;
([self.dimension, self.diameters] = [dimension, diameters]);
(self.rows = new Rows(new _Pair(dimension), 0, 500));
(entries = [new Entry("rows", "Pairs of position, 0 in the middle of the belt, and value.", $bound(self, "rows")), new Entry("crown", "Height of a parabola in the middle over the edges of the belt.", new Quantity(dimension)), new Entry("factor", "Factor on all values: how much of the profile there is.", new Quantity("number", $call(Limit, ["number"], [["most", 100.0]]))), new Entry("uncertainty", "Standard uncertainty of the values.", new Quantity(dimension, new Limit(dimension)))]);
if ($truth(diameters)) {
(words = "Whether the values are on radius (if left out) or on diameter.");
$m.append(entries, new Entry("on", words, new Choice(["radius", "diameter"])));
}
(self.within = new TextOr($bound(self, "rows"), $call(Table, ["Profile", ...$iter(entries)], [["on_one_line", true]])));
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
(built = report.tried((() => $call(WidthProfile, [], [["position", $b.tuple((function* () { for (const [y, _] of $iter(rows)) { yield y; } })())], ["value", $b.tuple(values)], ["crown", crown], ["uncertainty", (($in("uncertainty", table)) ? $mul($mul(factor, half), $at(table, "uncertainty")) : null)]])), place));
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
const $c634 = $made(Quantity, {dimension: "number", limit: null});
const $c622 = $made(Entry, {key: "format", kind: $c634, required: true, alias: "", example: "format = 1", attribute: "format", unless: ""});
const $c635 = $made(Text, {longest: 200, lines: false});
const $c623 = $made(Entry, {key: "title", kind: $c635, required: false, alias: "", example: "", attribute: "title", unless: ""});
const $c636 = $made(Text, {longest: 5000, lines: true});
const $c624 = $made(Entry, {key: "description", kind: $c636, required: false, alias: "", example: "", attribute: "description", unless: ""});
const $c582 = $made(Limit, {dimension: "length", least: 0.0, most: 1.0, open: true, rigid: false});
const $c637 = $made(Quantity, {dimension: "length", limit: $c582});
const $c625 = $made(Entry, {key: "creep_limit", kind: $c637, required: false, alias: "", example: "", attribute: "creep_limit", unless: ""});
const $c639 = $made(Name, {longest: 60});
const $c647 = $made(Name, {longest: 60});
const $c642 = $made(Entry, {key: "name", kind: $c647, required: true, alias: "", example: "", attribute: "name", unless: ""});
const $c577 = $made(Limit, {dimension: "number", least: 0.0, most: 2.0, open: true, rigid: false});
const $c648 = $made(Quantity, {dimension: "number", limit: $c577});
const $c643 = $made(Entry, {key: "friction_factor", kind: $c648, required: false, alias: "", example: "", attribute: "factor", unless: ""});
const $c649 = $made(ByName, {kind: $c648, most: 200});
const $c644 = $made(Entry, {key: "friction_factors", kind: $c649, required: false, alias: "", example: "", attribute: "friction_factors", unless: ""});
const $c651 = ["DIN 22101", "practice"];
const $c650 = $made(Choice, {options: $c651});
const $c645 = $made(Entry, {key: "standard", kind: $c650, required: false, alias: "", example: "", attribute: "standard", unless: ""});
const $c659 = ["measured", "published", "calibrated", "illustrative", "given"];
const $c658 = $made(Choice, {options: $c659});
const $c654 = $made(Entry, {key: "kind", kind: $c658, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c660 = $made(Text, {longest: 500, lines: false});
const $c655 = $made(Entry, {key: "source", kind: $c660, required: false, alias: "", example: "", attribute: "source", unless: ""});
const $c661 = $made(Text, {longest: 60, lines: false});
const $c656 = $made(Entry, {key: "date", kind: $c661, required: false, alias: "", example: "", attribute: "date", unless: ""});
const $c662 = $made(Text, {longest: 1000, lines: false});
const $c657 = $made(Entry, {key: "note", kind: $c662, required: false, alias: "", example: "", attribute: "note", unless: ""});
const $c652 = [$c654, $c655, $c656, $c657];
const $c653 = new Map([["kind", $c654], ["source", $c655], ["date", $c656], ["note", $c657]]);
const $c2 = $made(Table, {of: Provenance, entries: $c652, _known: $c653});
const $c646 = $made(Entry, {key: "provenance", kind: $c2, required: false, alias: "", example: "", attribute: "provenance", unless: ""});
const $c640 = [$c642, $c643, $c644, $c645, $c646];
const $c641 = new Map([["name", $c642], ["friction_factor", $c643], ["friction_factors", $c644], ["standard", $c645], ["provenance", $c646]]);
const $c8 = $made(Table, {of: Condition, entries: $c640, _known: $c641});
const $c159 = $made(TextOr, {text: $c639, table: $c8});
const $c638 = $made(OneOrMore, {kind: $c159, most: 8});
const $c626 = $made(Entry, {key: "condition", kind: $c638, required: false, alias: "", example: "", attribute: "condition", unless: ""});
const $c100 = $made(Name, {longest: 60});
const $c80 = $made(Entry, {key: "preset", kind: $c100, required: false, alias: "", example: "", attribute: "preset", unless: ""});
const $c101 = $made(Name, {longest: 60});
const $c81 = $made(Entry, {key: "name", kind: $c101, required: false, alias: "", example: "", attribute: "name", unless: ""});
const $c102 = $made(Text, {longest: 60, lines: false});
const $c82 = $made(Entry, {key: "kind", kind: $c102, required: false, alias: "", example: "", attribute: "kind", unless: ""});
const $c121 = $made(Limit, {dimension: "length", least: 0.001, most: 1000.0, open: false, rigid: false});
const $c103 = $made(Quantity, {dimension: "length", limit: $c121});
const $c83 = $made(Entry, {key: "width", kind: $c103, required: true, alias: "", example: "", attribute: "width", unless: ""});
const $c122 = $made(Limit, {dimension: "force_per_width", least: 1000.0, most: Infinity, open: false, rigid: true});
const $c105 = $made(Quantity, {dimension: "force_per_width", limit: $c122});
const $c104 = $made(WordOr, {word: "rigid", kind: $c105, meaning: Infinity});
const $c84 = $made(Entry, {key: "modulus", kind: $c104, required: false, alias: "", example: "", attribute: "modulus", unless: ""});
const $c123 = $made(Limit, {dimension: "force_per_width", least: 0.0, most: Infinity, open: true, rigid: false});
const $c106 = $made(Quantity, {dimension: "force_per_width", limit: $c123});
const $c85 = $made(Entry, {key: "rating", kind: $c106, required: false, alias: "", example: "", attribute: "rating", unless: ""});
const $c124 = $made(Limit, {dimension: "force_per_width", least: 0.0, most: Infinity, open: true, rigid: false});
const $c107 = $made(Quantity, {dimension: "force_per_width", limit: $c124});
const $c86 = $made(Entry, {key: "strength", kind: $c107, required: false, alias: "", example: "", attribute: "strength", unless: ""});
const $c125 = $made(Limit, {dimension: "speed", least: 0.0, most: 1000.0, open: true, rigid: false});
const $c108 = $made(Quantity, {dimension: "speed", limit: $c125});
const $c87 = $made(Entry, {key: "speed", kind: $c108, required: false, alias: "", example: "", attribute: "speed", unless: ""});
const $c126 = $made(Limit, {dimension: "number", least: 1.0, most: 10.0, open: false, rigid: false});
const $c109 = $made(Quantity, {dimension: "number", limit: $c126});
const $c88 = $made(Entry, {key: "momentary_factor", kind: $c109, required: false, alias: "", example: "", attribute: "momentary_factor", unless: ""});
const $c127 = $made(Limit, {dimension: "length", least: 0.0, most: Infinity, open: true, rigid: false});
const $c110 = $made(Quantity, {dimension: "length", limit: $c127});
const $c89 = $made(Entry, {key: "least_pulley_diameter", kind: $c110, required: false, alias: "", example: "", attribute: "least_pulley_diameter", unless: ""});
const $c128 = $made(Limit, {dimension: "pressure", least: 0.0, most: Infinity, open: true, rigid: false});
const $c111 = $made(Quantity, {dimension: "pressure", limit: $c128});
const $c90 = $made(Entry, {key: "largest_wrap_pressure", kind: $c111, required: false, alias: "", example: "", attribute: "largest_wrap_pressure", unless: ""});
const $c129 = $made(Limit, {dimension: "force_per_width", least: 1.0, most: 1000000000.0, open: false, rigid: false});
const $c112 = $made(Quantity, {dimension: "force_per_width", limit: $c129});
const $c91 = $made(Entry, {key: "in_plane_shear_stiffness", kind: $c112, required: false, alias: "", example: "", attribute: "in_plane_shear_stiffness", unless: ""});
const $c130 = $made(Limit, {dimension: "length", least: 0.0, most: 0.06, open: false, rigid: false});
const $c113 = $made(Quantity, {dimension: "length", limit: $c130});
const $c92 = $made(Entry, {key: "pulley_cover", kind: $c113, required: false, alias: "", example: "", attribute: "pulley_cover", unless: ""});
const $c131 = $made(Limit, {dimension: "length", least: 0.0, most: 0.06, open: false, rigid: false});
const $c114 = $made(Quantity, {dimension: "length", limit: $c131});
const $c93 = $made(Entry, {key: "carry_cover", kind: $c114, required: false, alias: "", example: "", attribute: "carry_cover", unless: ""});
const $c132 = $made(Limit, {dimension: "length", least: 0.0, most: 0.06, open: true, rigid: false});
const $c115 = $made(Quantity, {dimension: "length", limit: $c132});
const $c94 = $made(Entry, {key: "carcass", kind: $c115, required: false, alias: "", example: "", attribute: "carcass", unless: ""});
const $c133 = $made(Limit, {dimension: "length", least: 0.0, most: 0.06, open: true, rigid: false});
const $c116 = $made(Quantity, {dimension: "length", limit: $c133});
const $c95 = $made(Entry, {key: "thickness", kind: $c116, required: false, alias: "", example: "", attribute: "thickness", unless: ""});
const $c134 = $made(Limit, {dimension: "pressure", least: 100000.0, most: 100000000.0, open: false, rigid: true});
const $c118 = $made(Quantity, {dimension: "pressure", limit: $c134});
const $c117 = $made(WordOr, {word: "rigid", kind: $c118, meaning: Infinity});
const $c96 = $made(Entry, {key: "cover_shear_modulus", kind: $c117, required: false, alias: "", example: "", attribute: "cover_shear_modulus", unless: ""});
const $c135 = $made(Limit, {dimension: "mass_per_length", least: 0.0, most: 1000000.0, open: true, rigid: false});
const $c119 = $made(Quantity, {dimension: "mass_per_length", limit: $c135});
const $c97 = $made(Entry, {key: "mass", kind: $c119, required: false, alias: "", example: "", attribute: "mass", unless: ""});
const $c98 = $made(Entry, {key: "provenance", kind: $c2, required: false, alias: "", example: "", attribute: "provenance", unless: ""});
const $c120 = $made(ByName, {kind: $c2, most: 200});
const $c99 = $made(Entry, {key: "sources", kind: $c120, required: false, alias: "", example: "", attribute: "sources", unless: ""});
const $c1 = [$c80, $c81, $c82, $c83, $c84, $c85, $c86, $c87, $c88, $c89, $c90, $c91, $c92, $c93, $c94, $c95, $c96, $c97, $c98, $c99];
const $c663 = new Map([["preset", $c80], ["name", $c81], ["kind", $c82], ["width", $c83], ["modulus", $c84], ["rating", $c85], ["strength", $c86], ["speed", $c87], ["momentary_factor", $c88], ["least_pulley_diameter", $c89], ["largest_wrap_pressure", $c90], ["in_plane_shear_stiffness", $c91], ["pulley_cover", $c92], ["carry_cover", $c93], ["carcass", $c94], ["thickness", $c95], ["cover_shear_modulus", $c96], ["mass", $c97], ["provenance", $c98], ["sources", $c99]]);
const $c5 = $made(Table, {of: Belt, entries: $c1, _known: $c663});
const $c627 = $made(Entry, {key: "belt", kind: $c5, required: true, alias: "", example: "a [belt] table", attribute: "belt", unless: ""});
const $c154 = $made(Name, {longest: 60});
const $c136 = $made(Entry, {key: "name", kind: $c154, required: true, alias: "", example: "name = \"head\"", attribute: "name", unless: ""});
const $c666 = $made(Limit, {dimension: "length", least: 0.001, most: 1000.0, open: false, rigid: false});
const $c155 = $made(Quantity, {dimension: "length", limit: $c666});
const $c137 = $made(Entry, {key: "diameter", kind: $c155, required: true, alias: "", example: "", attribute: "diameter", unless: ""});
const $c667 = $made(Limit, {dimension: "angle", least: 0.017453292519943295, most: 12.566370614359172, open: false, rigid: false});
const $c156 = $made(Quantity, {dimension: "angle", limit: $c667});
const $c138 = $made(Entry, {key: "wrap_angle", kind: $c156, required: true, alias: "wrap", example: "", attribute: "wrap_angle", unless: "belt_path"});
const $c578 = $made(Limit, {dimension: "length", least: -100000.0, most: 100000.0, open: false, rigid: false});
const $c675 = $made(Quantity, {dimension: "length", limit: $c578});
const $c670 = $made(Entry, {key: "x", kind: $c675, required: true, alias: "", example: "", attribute: "x", unless: ""});
const $c676 = $made(Quantity, {dimension: "length", limit: $c578});
const $c671 = $made(Entry, {key: "y", kind: $c676, required: true, alias: "", example: "", attribute: "y", unless: ""});
const $c678 = ["clockwise", "counterclockwise"];
const $c677 = $made(Choice, {options: $c678});
const $c672 = $made(Entry, {key: "turn", kind: $c677, required: false, alias: "", example: "", attribute: "turn", unless: ""});
const $c685 = $made(Quantity, {dimension: "length", limit: $c578});
const $c682 = $made(Entry, {key: "x", kind: $c685, required: true, alias: "", example: "", attribute: "x", unless: ""});
const $c686 = $made(Quantity, {dimension: "length", limit: $c578});
const $c683 = $made(Entry, {key: "y", kind: $c686, required: true, alias: "", example: "", attribute: "y", unless: ""});
const $c579 = $made(Limit, {dimension: "length", least: 0.0, most: 1000.0, open: false, rigid: false});
const $c687 = $made(Quantity, {dimension: "length", limit: $c579});
const $c684 = $made(Entry, {key: "diameter", kind: $c687, required: false, alias: "", example: "", attribute: "diameter", unless: ""});
const $c680 = [$c682, $c683, $c684, $c672];
const $c681 = new Map([["x", $c682], ["y", $c683], ["diameter", $c684], ["turn", $c672]]);
const $c679 = $made(Table, {of: Point, entries: $c680, _known: $c681});
const $c673 = $made(Entry, {key: "before", kind: $c679, required: true, alias: "", example: "a table with x and y", attribute: "before", unless: ""});
const $c674 = $made(Entry, {key: "after", kind: $c679, required: true, alias: "", example: "a table with x and y", attribute: "after", unless: ""});
const $c668 = [$c670, $c671, $c672, $c673, $c674];
const $c669 = new Map([["x", $c670], ["y", $c671], ["turn", $c672], ["before", $c673], ["after", $c674]]);
const $c157 = $made(Table, {of: Point, entries: $c668, _known: $c669});
const $c139 = $made(Entry, {key: "belt_path", kind: $c157, required: false, alias: "", example: "", attribute: "belt_path", unless: ""});
const $c688 = $made(Name, {longest: 500});
const $c712 = $made(Name, {longest: 500});
const $c692 = $made(Entry, {key: "preset", kind: $c712, required: false, alias: "", example: "", attribute: "preset", unless: ""});
const $c713 = $made(Name, {longest: 60});
const $c693 = $made(Entry, {key: "name", kind: $c713, required: false, alias: "", example: "", attribute: "name", unless: ""});
const $c714 = $made(Text, {longest: 200, lines: false});
const $c694 = $made(Entry, {key: "title", kind: $c714, required: false, alias: "", example: "", attribute: "title", unless: ""});
const $c715 = $made(Text, {longest: 5000, lines: true});
const $c695 = $made(Entry, {key: "description", kind: $c715, required: false, alias: "", example: "", attribute: "description", unless: ""});
const $c597 = ["bare", "rubber", "polyurethane", "ceramic"];
const $c716 = $made(Choice, {options: $c597});
const $c696 = $made(Entry, {key: "surface", kind: $c716, required: false, alias: "", example: "", attribute: "surface", unless: ""});
const $c584 = $made(Limit, {dimension: "length", least: 0.0, most: 1.0, open: false, rigid: false});
const $c717 = $made(Quantity, {dimension: "length", limit: $c584});
const $c697 = $made(Entry, {key: "thickness", kind: $c717, required: false, alias: "", example: "", attribute: "thickness", unless: ""});
const $c587 = $made(Limit, {dimension: "pressure", least: 1000.0, most: Infinity, open: false, rigid: false});
const $c718 = $made(Quantity, {dimension: "pressure", limit: $c587});
const $c698 = $made(Entry, {key: "elastic_modulus", kind: $c718, required: false, alias: "", example: "", attribute: "elastic_modulus", unless: ""});
const $c585 = $made(Limit, {dimension: "pressure", least: 1000.0, most: Infinity, open: false, rigid: true});
const $c720 = $made(Quantity, {dimension: "pressure", limit: $c585});
const $c719 = $made(WordOr, {word: "rigid", kind: $c720, meaning: Infinity});
const $c699 = $made(Entry, {key: "shear_modulus", kind: $c719, required: false, alias: "", example: "", attribute: "shear_modulus", unless: ""});
const $c586 = $made(Limit, {dimension: "pressure", least: 1000.0, most: Infinity, open: false, rigid: true});
const $c722 = $made(Quantity, {dimension: "pressure", limit: $c586});
const $c721 = $made(WordOr, {word: "rigid", kind: $c722, meaning: Infinity});
const $c700 = $made(Entry, {key: "compression_modulus", kind: $c721, required: false, alias: "", example: "", attribute: "compression_modulus", unless: ""});
const $c606 = ["square", "strip"];
const $c730 = $made(Choice, {options: $c606});
const $c725 = $made(Entry, {key: "shape", kind: $c730, required: false, alias: "", example: "", attribute: "shape", unless: ""});
const $c732 = $made(Limit, {dimension: "length", least: 0.0001, most: 10.0, open: false, rigid: false});
const $c731 = $made(Quantity, {dimension: "length", limit: $c732});
const $c726 = $made(Entry, {key: "width", kind: $c731, required: true, alias: "", example: "", attribute: "width", unless: ""});
const $c734 = $made(Limit, {dimension: "length", least: 0.0001, most: 1.0, open: false, rigid: false});
const $c733 = $made(Quantity, {dimension: "length", limit: $c734});
const $c727 = $made(Entry, {key: "height", kind: $c733, required: false, alias: "", example: "", attribute: "height", unless: ""});
const $c736 = $made(Limit, {dimension: "number", least: 0.0, most: 10.0, open: false, rigid: false});
const $c735 = $made(Quantity, {dimension: "number", limit: $c736});
const $c728 = $made(Entry, {key: "stiffening", kind: $c735, required: false, alias: "", example: "", attribute: "stiffening", unless: ""});
const $c738 = $made(Limit, {dimension: "number", least: 0.01, most: 1.0, open: false, rigid: false});
const $c737 = $made(Quantity, {dimension: "number", limit: $c738});
const $c729 = $made(Entry, {key: "contact_fraction", kind: $c737, required: false, alias: "", example: "", attribute: "contact_fraction", unless: ""});
const $c723 = [$c725, $c726, $c727, $c728, $c729];
const $c724 = new Map([["shape", $c725], ["width", $c726], ["height", $c727], ["stiffening", $c728], ["contact_fraction", $c729]]);
const $c48 = $made(Table, {of: Block, entries: $c723, _known: $c724});
const $c701 = $made(Entry, {key: "block", kind: $c48, required: false, alias: "", example: "", attribute: "block", unless: ""});
const $c588 = $made(Limit, {dimension: "wear_coefficient", least: 0.0, most: 1.0, open: false, rigid: false});
const $c739 = $made(Quantity, {dimension: "wear_coefficient", limit: $c588});
const $c702 = $made(Entry, {key: "wear_coefficient", kind: $c739, required: false, alias: "", example: "", attribute: "wear_coefficient", unless: ""});
const $c589 = $made(Limit, {dimension: "number", least: 0.0, most: 1.0, open: false, rigid: false});
const $c740 = $made(Quantity, {dimension: "number", limit: $c589});
const $c703 = $made(Entry, {key: "belt_energy_share", kind: $c740, required: false, alias: "", example: "", attribute: "belt_energy_share", unless: ""});
const $c590 = $made(Limit, {dimension: "pressure", least: 0.0, most: Infinity, open: true, rigid: false});
const $c741 = $made(Quantity, {dimension: "pressure", limit: $c590});
const $c704 = $made(Entry, {key: "bond_strength", kind: $c741, required: false, alias: "", example: "", attribute: "bond_strength", unless: ""});
const $c591 = $made(Limit, {dimension: "pressure", least: 0.0, most: Infinity, open: true, rigid: false});
const $c742 = $made(Quantity, {dimension: "pressure", limit: $c591});
const $c705 = $made(Entry, {key: "fatigue_limit", kind: $c742, required: false, alias: "", example: "", attribute: "fatigue_limit", unless: ""});
const $c751 = $made(Limit, {dimension: "number", least: 0.0, most: Infinity, open: false, rigid: false});
const $c750 = $made(Quantity, {dimension: "number", limit: $c751});
const $c745 = $made(Entry, {key: "material", kind: $c750, required: true, alias: "", example: "", attribute: "material", unless: ""});
const $c753 = $made(Limit, {dimension: "number", least: 0.0, most: Infinity, open: false, rigid: false});
const $c752 = $made(Quantity, {dimension: "number", limit: $c753});
const $c746 = $made(Entry, {key: "installation", kind: $c752, required: true, alias: "", example: "", attribute: "installation", unless: ""});
const $c754 = $made(Name, {longest: 12});
const $c747 = $made(Entry, {key: "currency", kind: $c754, required: true, alias: "", example: "", attribute: "currency", unless: ""});
const $c756 = $made(Limit, {dimension: "area", least: 0.0, most: Infinity, open: true, rigid: false});
const $c755 = $made(Quantity, {dimension: "area", limit: $c756});
const $c748 = $made(Entry, {key: "area", kind: $c755, required: true, alias: "", example: "", attribute: "area", unless: ""});
const $c758 = $made(Quantity, {dimension: "number", limit: null});
const $c757 = $made(Rows, {kind: $c758, least: 2, most: 2});
const $c749 = $made(Entry, {key: "life_years", kind: $c757, required: true, alias: "", example: "", attribute: "life_years", unless: ""});
const $c743 = [$c745, $c746, $c747, $c748, $c749];
const $c744 = new Map([["material", $c745], ["installation", $c746], ["currency", $c747], ["area", $c748], ["life_years", $c749]]);
const $c45 = $made(Table, {of: Cost, entries: $c743, _known: $c744});
const $c706 = $made(Entry, {key: "cost", kind: $c45, required: false, alias: "", example: "", attribute: "cost", unless: ""});
const $c760 = $made(Limit, {dimension: "speed", least: 0.0, most: Infinity, open: true, rigid: false});
const $c759 = $made(Quantity, {dimension: "speed", limit: $c760});
const $c707 = $made(Entry, {key: "slip_speed", kind: $c759, required: false, alias: "", example: "", attribute: "slip_speed", unless: ""});
const $c762 = $made(Limit, {dimension: "temperature", least: 0.0, most: Infinity, open: false, rigid: false});
const $c761 = $made(Quantity, {dimension: "temperature", limit: $c762});
const $c708 = $made(Entry, {key: "temperature", kind: $c761, required: false, alias: "", example: "", attribute: "temperature", unless: ""});
const $c769 = $made(Name, {longest: 60});
const $c766 = $made(Entry, {key: "condition", kind: $c769, required: true, alias: "", example: "", attribute: "condition", unless: ""});
const $c771 = $made(Limit, {dimension: "number", least: 0.0, most: 10.0, open: true, rigid: false});
const $c770 = $made(Quantity, {dimension: "number", limit: $c771});
const $c767 = $made(Entry, {key: "factor", kind: $c770, required: true, alias: "", example: "", attribute: "factor", unless: ""});
const $c768 = $made(Entry, {key: "provenance", kind: $c2, required: true, alias: "", example: "", attribute: "provenance", unless: ""});
const $c764 = [$c766, $c767, $c768];
const $c765 = new Map([["condition", $c766], ["factor", $c767], ["provenance", $c768]]);
const $c49 = $made(Table, {of: ConditionFactor, entries: $c764, _known: $c765});
const $c763 = $made(Rows, {kind: $c49, least: 0, most: 20});
const $c709 = $made(Entry, {key: "condition_factor", kind: $c763, required: false, alias: "", example: "", attribute: "condition_factor", unless: ""});
const $c799 = ["integral-log"];
const $c798 = $made(Choice, {options: $c799});
const $c781 = $made(Entry, {key: "kind", kind: $c798, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c800 = $made(Name, {longest: 60});
const $c782 = $made(Entry, {key: "condition", kind: $c800, required: false, alias: "", example: "", attribute: "condition", unless: ""});
const $c783 = $made(Entry, {key: "provenance", kind: $c2, required: false, alias: "", example: "", attribute: "provenance", unless: ""});
const $c784 = $made(Entry, {key: "condition_source", kind: $c2, required: false, alias: "", example: "", attribute: "condition_source", unless: ""});
const $c813 = $made(Name, {longest: 120});
const $c812 = $made(Rows, {kind: $c813, least: 1, most: 1000});
const $c803 = $made(Entry, {key: "parameters", kind: $c812, required: true, alias: "", example: "", attribute: "parameters", unless: ""});
const $c814 = $made(Rows, {kind: $c758, least: 1, most: 1000});
const $c804 = $made(Entry, {key: "values", kind: $c814, required: true, alias: "", example: "", attribute: "values", unless: ""});
const $c816 = $made(Rows, {kind: $c758, least: 1, most: 1000});
const $c815 = $made(Rows, {kind: $c816, least: 1, most: 1000});
const $c805 = $made(Entry, {key: "covariance", kind: $c815, required: true, alias: "", example: "", attribute: "covariance", unless: ""});
const $c818 = $made(Limit, {dimension: "number", least: 0.0, most: Infinity, open: false, rigid: false});
const $c817 = $made(Quantity, {dimension: "number", limit: $c818});
const $c806 = $made(Entry, {key: "residual_noise", kind: $c817, required: false, alias: "", example: "", attribute: "residual_noise", unless: ""});
const $c820 = $made(Limit, {dimension: "number", least: 1.0, most: Infinity, open: false, rigid: false});
const $c819 = $made(Quantity, {dimension: "number", limit: $c820});
const $c807 = $made(Entry, {key: "coverage_factor", kind: $c819, required: false, alias: "", example: "", attribute: "coverage_factor", unless: ""});
const $c821 = $made(Text, {longest: 60, lines: false});
const $c808 = $made(Entry, {key: "date", kind: $c821, required: false, alias: "", example: "", attribute: "date", unless: ""});
const $c822 = $made(Text, {longest: 500, lines: false});
const $c809 = $made(Entry, {key: "method", kind: $c822, required: false, alias: "", example: "", attribute: "method", unless: ""});
const $c824 = $made(Text, {longest: 2000, lines: true});
const $c823 = $made(Rows, {kind: $c824, least: 0, most: 50});
const $c810 = $made(Entry, {key: "misfit", kind: $c823, required: false, alias: "", example: "", attribute: "misfit", unless: ""});
const $c825 = $made(Text, {longest: 500, lines: false});
const $c811 = $made(Entry, {key: "misfit_accepted", kind: $c825, required: false, alias: "", example: "", attribute: "misfit_accepted", unless: ""});
const $c801 = [$c803, $c804, $c805, $c806, $c807, $c808, $c809, $c810, $c811];
const $c802 = new Map([["parameters", $c803], ["values", $c804], ["covariance", $c805], ["residual_noise", $c806], ["coverage_factor", $c807], ["date", $c808], ["method", $c809], ["misfit", $c810], ["misfit_accepted", $c811]]);
const $c56 = $made(Table, {of: Fit, entries: $c801, _known: $c802});
const $c785 = $made(Entry, {key: "fit", kind: $c56, required: false, alias: "", example: "", attribute: "fit", unless: ""});
const $c828 = ["lagging shear", "cover shear"];
const $c827 = $made(Choice, {options: $c828});
const $c826 = $made(Rows, {kind: $c827, least: 0, most: 2});
const $c786 = $made(Entry, {key: "slip_includes", kind: $c826, required: false, alias: "", example: "", attribute: "slip_includes", unless: ""});
const $c835 = $made(Limit, {dimension: "speed", least: 0.0, most: Infinity, open: true, rigid: false});
const $c834 = $made(Quantity, {dimension: "speed", limit: $c835});
const $c833 = $made(Rows, {kind: $c834, least: 2, most: 100});
const $c831 = $made(Entry, {key: "slip_speed", kind: $c833, required: true, alias: "", example: "", attribute: "at", unless: ""});
const $c836 = $made(Rows, {kind: $c770, least: 2, most: 100});
const $c832 = $made(Entry, {key: "factor", kind: $c836, required: true, alias: "", example: "", attribute: "factor", unless: ""});
const $c829 = [$c831, $c832, $c768];
const $c830 = new Map([["slip_speed", $c831], ["factor", $c832], ["provenance", $c768]]);
const $c54 = $made(Table, {of: FrictionFactor, entries: $c829, _known: $c830});
const $c787 = $made(Entry, {key: "slip_speed_factor", kind: $c54, required: false, alias: "", example: "", attribute: "slip_speed_factor", unless: ""});
const $c842 = $made(Limit, {dimension: "temperature", least: 0.0, most: Infinity, open: false, rigid: false});
const $c841 = $made(Quantity, {dimension: "temperature", limit: $c842});
const $c840 = $made(Rows, {kind: $c841, least: 2, most: 100});
const $c839 = $made(Entry, {key: "temperature", kind: $c840, required: true, alias: "", example: "", attribute: "at", unless: ""});
const $c837 = [$c839, $c832, $c768];
const $c838 = new Map([["temperature", $c839], ["factor", $c832], ["provenance", $c768]]);
const $c55 = $made(Table, {of: FrictionFactor, entries: $c837, _known: $c838});
const $c788 = $made(Entry, {key: "temperature_factor", kind: $c55, required: false, alias: "", example: "", attribute: "temperature_factor", unless: ""});
const $c789 = $made(Entry, {key: "notes", kind: $c823, required: false, alias: "", example: "", attribute: "notes", unless: ""});
const $c845 = $made(Limit, {dimension: "pressure", least: 0.0, most: 1000000000.0, open: true, rigid: false});
const $c844 = $made(Quantity, {dimension: "pressure", limit: $c845});
const $c843 = $made(Rows, {kind: $c844, least: 2, most: 2});
const $c790 = $made(Entry, {key: "tested_pressure", kind: $c843, required: false, alias: "", example: "", attribute: "tested_pressure", unless: ""});
const $c847 = $made(Limit, {dimension: "length", least: 0.0, most: 1.0, open: true, rigid: false});
const $c846 = $made(Quantity, {dimension: "length", limit: $c847});
const $c791 = $made(Entry, {key: "tested_slip", kind: $c846, required: false, alias: "", example: "", attribute: "tested_slip", unless: ""});
const $c849 = $made(Limit, {dimension: "speed", least: 0.0, most: Infinity, open: true, rigid: false});
const $c848 = $made(Quantity, {dimension: "speed", limit: $c849});
const $c792 = $made(Entry, {key: "tested_slip_speed", kind: $c848, required: false, alias: "", example: "", attribute: "tested_slip_speed", unless: ""});
const $c854 = $made(Entry, {key: "pressure", kind: $c844, required: true, alias: "", example: "", attribute: "pressure", unless: ""});
const $c860 = $made(Limit, {dimension: "number", least: 0.0, most: 5.0, open: true, rigid: false});
const $c859 = $made(Quantity, {dimension: "number", limit: $c860});
const $c855 = $made(Entry, {key: "peak_friction", kind: $c859, required: true, alias: "", example: "", attribute: "peak_friction", unless: ""});
const $c856 = $made(Entry, {key: "peak_slip", kind: $c846, required: true, alias: "", example: "", attribute: "peak_slip", unless: ""});
const $c862 = $made(Limit, {dimension: "per_length", least: -1000000.0, most: 0.0, open: false, rigid: false});
const $c861 = $made(Quantity, {dimension: "per_length", limit: $c862});
const $c857 = $made(Entry, {key: "post_peak_slope", kind: $c861, required: false, alias: "", example: "", attribute: "post_peak_slope", unless: ""});
const $c858 = $made(Entry, {key: "residual_friction", kind: $c859, required: false, alias: "", example: "", attribute: "residual_friction", unless: ""});
const $c852 = [$c854, $c855, $c856, $c857, $c858];
const $c853 = new Map([["pressure", $c854], ["peak_friction", $c855], ["peak_slip", $c856], ["post_peak_slope", $c857], ["residual_friction", $c858]]);
const $c851 = $made(Table, {of: null, entries: $c852, _known: $c853});
const $c850 = $made(Rows, {kind: $c851, least: 1, most: 200});
const $c793 = $made(Entry, {key: "knots", kind: $c850, required: false, alias: "", example: "", attribute: "knots", unless: ""});
const $c867 = $made(Entry, {key: "from", kind: $c844, required: true, alias: "", example: "", attribute: "from", unless: ""});
const $c868 = $made(Entry, {key: "to", kind: $c844, required: true, alias: "", example: "", attribute: "to", unless: ""});
const $c873 = $made(Text, {longest: 300, lines: false});
const $c869 = $made(Entry, {key: "A", kind: $c873, required: true, alias: "", example: "", attribute: "A", unless: ""});
const $c870 = $made(Entry, {key: "b", kind: $c873, required: true, alias: "", example: "", attribute: "b", unless: ""});
const $c871 = $made(Entry, {key: "post_peak_slope", kind: $c873, required: false, alias: "", example: "", attribute: "post_peak_slope", unless: ""});
const $c872 = $made(Entry, {key: "residual_friction", kind: $c873, required: false, alias: "", example: "", attribute: "residual_friction", unless: ""});
const $c865 = [$c867, $c868, $c869, $c870, $c871, $c872];
const $c866 = new Map([["from", $c867], ["to", $c868], ["A", $c869], ["b", $c870], ["post_peak_slope", $c871], ["residual_friction", $c872]]);
const $c864 = $made(Table, {of: null, entries: $c865, _known: $c866});
const $c863 = $made(Rows, {kind: $c864, least: 1, most: 50});
const $c794 = $made(Entry, {key: "pieces", kind: $c863, required: false, alias: "", example: "", attribute: "pieces", unless: ""});
const $c874 = $made(Text, {longest: 20, lines: false});
const $c795 = $made(Entry, {key: "slip_unit", kind: $c874, required: false, alias: "", example: "", attribute: "slip_unit", unless: ""});
const $c875 = $made(Text, {longest: 20, lines: false});
const $c796 = $made(Entry, {key: "pressure_unit", kind: $c875, required: false, alias: "", example: "", attribute: "pressure_unit", unless: ""});
const $c877 = $made(Limit, {dimension: "number", least: 0.0, most: 0.5, open: false, rigid: false});
const $c876 = $made(Quantity, {dimension: "number", limit: $c877});
const $c797 = $made(Entry, {key: "continuity", kind: $c876, required: false, alias: "", example: "", attribute: "continuity", unless: ""});
const $c779 = [$c781, $c782, $c783, $c784, $c785, $c786, $c787, $c788, $c789, $c790, $c791, $c792, $c793, $c794, $c795, $c796, $c797];
const $c780 = new Map([["kind", $c781], ["condition", $c782], ["provenance", $c783], ["condition_source", $c784], ["fit", $c785], ["slip_includes", $c786], ["slip_speed_factor", $c787], ["temperature_factor", $c788], ["notes", $c789], ["tested_pressure", $c790], ["tested_slip", $c791], ["tested_slip_speed", $c792], ["knots", $c793], ["pieces", $c794], ["slip_unit", $c795], ["pressure_unit", $c796], ["continuity", $c797]]);
const $c774 = $made(Table, {of: IntegralLog, entries: $c779, _known: $c780});
const $c883 = ["constant"];
const $c882 = $made(Choice, {options: $c883});
const $c880 = $made(Entry, {key: "kind", kind: $c882, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c881 = $made(Entry, {key: "friction", kind: $c859, required: true, alias: "", example: "", attribute: "friction_coefficient", unless: ""});
const $c878 = [$c880, $c782, $c783, $c784, $c785, $c786, $c787, $c788, $c789, $c790, $c791, $c792, $c881];
const $c879 = new Map([["kind", $c880], ["condition", $c782], ["provenance", $c783], ["condition_source", $c784], ["fit", $c785], ["slip_includes", $c786], ["slip_speed_factor", $c787], ["temperature_factor", $c788], ["notes", $c789], ["tested_pressure", $c790], ["tested_slip", $c791], ["tested_slip_speed", $c792], ["friction", $c881]]);
const $c775 = $made(Table, {of: Constant, entries: $c878, _known: $c879});
const $c889 = ["elastic-plastic"];
const $c888 = $made(Choice, {options: $c889});
const $c886 = $made(Entry, {key: "kind", kind: $c888, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c891 = $made(Limit, {dimension: "pressure_per_length", least: 0.0, most: 1000000000000000.0, open: true, rigid: false});
const $c890 = $made(Quantity, {dimension: "pressure_per_length", limit: $c891});
const $c887 = $made(Entry, {key: "stiffness", kind: $c890, required: true, alias: "", example: "", attribute: "stiffness", unless: ""});
const $c884 = [$c886, $c782, $c783, $c784, $c785, $c786, $c787, $c788, $c789, $c790, $c791, $c792, $c887, $c881];
const $c885 = new Map([["kind", $c886], ["condition", $c782], ["provenance", $c783], ["condition_source", $c784], ["fit", $c785], ["slip_includes", $c786], ["slip_speed_factor", $c787], ["temperature_factor", $c788], ["notes", $c789], ["tested_pressure", $c790], ["tested_slip", $c791], ["tested_slip_speed", $c792], ["stiffness", $c887], ["friction", $c881]]);
const $c776 = $made(Table, {of: ElasticPlastic, entries: $c884, _known: $c885});
const $c899 = ["power"];
const $c898 = $made(Choice, {options: $c899});
const $c894 = $made(Entry, {key: "kind", kind: $c898, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c895 = $made(Entry, {key: "friction", kind: $c859, required: true, alias: "", example: "", attribute: "friction_coefficient", unless: ""});
const $c896 = $made(Entry, {key: "reference_pressure", kind: $c844, required: true, alias: "", example: "", attribute: "reference_pressure", unless: ""});
const $c897 = $made(Entry, {key: "exponent", kind: $c758, required: true, alias: "", example: "", attribute: "exponent", unless: ""});
const $c892 = [$c894, $c782, $c783, $c784, $c785, $c786, $c787, $c788, $c789, $c790, $c791, $c792, $c895, $c896, $c897];
const $c893 = new Map([["kind", $c894], ["condition", $c782], ["provenance", $c783], ["condition_source", $c784], ["fit", $c785], ["slip_includes", $c786], ["slip_speed_factor", $c787], ["temperature_factor", $c788], ["notes", $c789], ["tested_pressure", $c790], ["tested_slip", $c791], ["tested_slip_speed", $c792], ["friction", $c895], ["reference_pressure", $c896], ["exponent", $c897]]);
const $c777 = $made(Table, {of: PressurePower, entries: $c892, _known: $c893});
const $c906 = ["table"];
const $c905 = $made(Choice, {options: $c906});
const $c902 = $made(Entry, {key: "kind", kind: $c905, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c909 = $made(Limit, {dimension: "length", least: 0.0, most: 1.0, open: false, rigid: false});
const $c908 = $made(Quantity, {dimension: "length", limit: $c909});
const $c907 = $made(Rows, {kind: $c908, least: 2, most: 1000});
const $c903 = $made(Entry, {key: "slip", kind: $c907, required: true, alias: "", example: "", attribute: "slip", unless: ""});
const $c914 = $made(Entry, {key: "pressure", kind: $c844, required: true, alias: "", example: "", attribute: "pressure", unless: ""});
const $c918 = $made(Limit, {dimension: "number", least: 0.0, most: 5.0, open: false, rigid: false});
const $c917 = $made(Quantity, {dimension: "number", limit: $c918});
const $c916 = $made(Rows, {kind: $c917, least: 2, most: 1000});
const $c915 = $made(Entry, {key: "friction", kind: $c916, required: true, alias: "", example: "", attribute: "values", unless: ""});
const $c912 = [$c914, $c915];
const $c913 = new Map([["pressure", $c914], ["friction", $c915]]);
const $c911 = $made(Table, {of: null, entries: $c912, _known: $c913});
const $c910 = $made(Rows, {kind: $c911, least: 1, most: 200});
const $c904 = $made(Entry, {key: "rows", kind: $c910, required: true, alias: "", example: "", attribute: "rows", unless: ""});
const $c900 = [$c902, $c782, $c783, $c784, $c785, $c786, $c787, $c788, $c789, $c903, $c904];
const $c901 = new Map([["kind", $c902], ["condition", $c782], ["provenance", $c783], ["condition_source", $c784], ["fit", $c785], ["slip_includes", $c786], ["slip_speed_factor", $c787], ["temperature_factor", $c788], ["notes", $c789], ["slip", $c903], ["rows", $c904]]);
const $c778 = $made(Table, {of: MeasuredTable, entries: $c900, _known: $c901});
const $c773 = new Map([["integral-log", $c774], ["constant", $c775], ["elastic-plastic", $c776], ["power", $c777], ["table", $c778]]);
const $c52 = $made(Variant, {tag: "kind", tables: $c773});
const $c772 = $made(OneOrMore, {kind: $c52, most: 50});
const $c710 = $made(Entry, {key: "law", kind: $c772, required: false, alias: "", example: "", attribute: "law", unless: ""});
const $c711 = $made(Entry, {key: "notes", kind: $c823, required: false, alias: "", example: "", attribute: "notes", unless: ""});
const $c690 = [$c692, $c693, $c694, $c695, $c696, $c697, $c698, $c699, $c700, $c701, $c702, $c703, $c704, $c705, $c706, $c707, $c708, $c709, $c710, $c98, $c99, $c711];
const $c691 = new Map([["preset", $c692], ["name", $c693], ["title", $c694], ["description", $c695], ["surface", $c696], ["thickness", $c697], ["elastic_modulus", $c698], ["shear_modulus", $c699], ["compression_modulus", $c700], ["block", $c701], ["wear_coefficient", $c702], ["belt_energy_share", $c703], ["bond_strength", $c704], ["fatigue_limit", $c705], ["cost", $c706], ["slip_speed", $c707], ["temperature", $c708], ["condition_factor", $c709], ["law", $c710], ["provenance", $c98], ["sources", $c99], ["notes", $c711]]);
const $c689 = $made(Table, {of: Lagging, entries: $c690, _known: $c691});
const $c158 = $made(TextOr, {text: $c688, table: $c689});
const $c140 = $made(Entry, {key: "lagging", kind: $c158, required: true, alias: "", example: "lagging = \"diamond-rubber\"", attribute: "lagging", unless: ""});
const $c141 = $made(Entry, {key: "condition", kind: $c159, required: false, alias: "", example: "", attribute: "condition", unless: ""});
const $c580 = $made(Limit, {dimension: "force", least: 0.1, most: 1000000000.0, open: false, rigid: false});
const $c160 = $made(Quantity, {dimension: "force", limit: $c580});
const $c142 = $made(Entry, {key: "entry_tension", kind: $c160, required: false, alias: "", example: "", attribute: "entry_tension", unless: ""});
const $c143 = $made(Entry, {key: "exit_tension", kind: $c160, required: false, alias: "", example: "", attribute: "exit_tension", unless: ""});
const $c161 = $made(Quantity, {dimension: "force", limit: null});
const $c144 = $made(Entry, {key: "effective_tension", kind: $c161, required: false, alias: "", example: "", attribute: "effective_tension", unless: ""});
const $c162 = $made(Quantity, {dimension: "torque", limit: null});
const $c145 = $made(Entry, {key: "torque", kind: $c162, required: false, alias: "", example: "", attribute: "torque", unless: ""});
const $c163 = $made(Quantity, {dimension: "power", limit: null});
const $c146 = $made(Entry, {key: "power", kind: $c163, required: false, alias: "", example: "", attribute: "power", unless: ""});
const $c919 = $made(Limit, {dimension: "length", least: -1.0, most: 1.0, open: false, rigid: false});
const $c165 = $made(Quantity, {dimension: "length", limit: $c919});
const $c164 = $made(WordOr, {word: "formula", kind: $c165, meaning: null});
const $c147 = $made(Entry, {key: "overrun", kind: $c164, required: false, alias: "", example: "", attribute: "overrun", unless: ""});
const $c166 = $made(Flag, {});
const $c148 = $made(Entry, {key: "recovery", kind: $c166, required: false, alias: "", example: "", attribute: "recovery", unless: ""});
const $c920 = $made(Limit, {dimension: "length", least: 0.0, most: 1.0, open: true, rigid: false});
const $c167 = $made(Quantity, {dimension: "length", limit: $c920});
const $c149 = $made(Entry, {key: "creep_limit", kind: $c167, required: false, alias: "", example: "", attribute: "creep_limit", unless: ""});
const $c603 = ["pulley", "carry"];
const $c168 = $made(Choice, {options: $c603});
const $c150 = $made(Entry, {key: "side", kind: $c168, required: false, alias: "", example: "", attribute: "side", unless: ""});
const $c921 = $made(Limit, {dimension: "mass", least: 0.0, most: 1000000.0, open: true, rigid: false});
const $c169 = $made(Quantity, {dimension: "mass", limit: $c921});
const $c151 = $made(Entry, {key: "mass", kind: $c169, required: false, alias: "", example: "", attribute: "mass", unless: ""});
const $c1356 = $made(Quantity, {dimension: "length", limit: null});
const $c1357 = $made(Quantity, {dimension: "length", limit: null});
const $c1355 = [$c1356, $c1357];
const $c1282 = $made(_Pair, {kinds: $c1355});
const $c1280 = $made(Rows, {kind: $c1282, least: 0, most: 500});
const $c1286 = $made(Entry, {key: "rows", kind: $c1280, required: false, alias: "", example: "", attribute: "rows", unless: ""});
const $c1291 = $made(Quantity, {dimension: "length", limit: null});
const $c1287 = $made(Entry, {key: "crown", kind: $c1291, required: false, alias: "", example: "", attribute: "crown", unless: ""});
const $c1293 = $made(Limit, {dimension: "number", least: 0.0, most: 100.0, open: false, rigid: false});
const $c1292 = $made(Quantity, {dimension: "number", limit: $c1293});
const $c1288 = $made(Entry, {key: "factor", kind: $c1292, required: false, alias: "", example: "", attribute: "factor", unless: ""});
const $c1295 = $made(Limit, {dimension: "length", least: 0.0, most: Infinity, open: false, rigid: false});
const $c1294 = $made(Quantity, {dimension: "length", limit: $c1295});
const $c1289 = $made(Entry, {key: "uncertainty", kind: $c1294, required: false, alias: "", example: "", attribute: "uncertainty", unless: ""});
const $c1297 = ["radius", "diameter"];
const $c1296 = $made(Choice, {options: $c1297});
const $c1290 = $made(Entry, {key: "on", kind: $c1296, required: false, alias: "", example: "", attribute: "on", unless: ""});
const $c1284 = [$c1286, $c1287, $c1288, $c1289, $c1290];
const $c1285 = new Map([["rows", $c1286], ["crown", $c1287], ["factor", $c1288], ["uncertainty", $c1289], ["on", $c1290]]);
const $c1283 = $made(Table, {of: null, entries: $c1284, _known: $c1285});
const $c1281 = $made(TextOr, {text: $c1280, table: $c1283});
const $c933 = $made(Profile, {dimension: "length", diameters: true, rows: $c1280, within: $c1281});
const $c924 = $made(Entry, {key: "shell_profile", kind: $c933, required: false, alias: "", example: "", attribute: "shell_profile", unless: ""});
const $c1359 = $made(Quantity, {dimension: "length", limit: null});
const $c1360 = $made(Quantity, {dimension: "length", limit: null});
const $c1358 = [$c1359, $c1360];
const $c1300 = $made(_Pair, {kinds: $c1358});
const $c1298 = $made(Rows, {kind: $c1300, least: 0, most: 500});
const $c1304 = $made(Entry, {key: "rows", kind: $c1298, required: false, alias: "", example: "", attribute: "rows", unless: ""});
const $c1309 = $made(Quantity, {dimension: "length", limit: null});
const $c1305 = $made(Entry, {key: "crown", kind: $c1309, required: false, alias: "", example: "", attribute: "crown", unless: ""});
const $c1311 = $made(Limit, {dimension: "number", least: 0.0, most: 100.0, open: false, rigid: false});
const $c1310 = $made(Quantity, {dimension: "number", limit: $c1311});
const $c1306 = $made(Entry, {key: "factor", kind: $c1310, required: false, alias: "", example: "", attribute: "factor", unless: ""});
const $c1313 = $made(Limit, {dimension: "length", least: 0.0, most: Infinity, open: false, rigid: false});
const $c1312 = $made(Quantity, {dimension: "length", limit: $c1313});
const $c1307 = $made(Entry, {key: "uncertainty", kind: $c1312, required: false, alias: "", example: "", attribute: "uncertainty", unless: ""});
const $c1314 = $made(Choice, {options: $c1297});
const $c1308 = $made(Entry, {key: "on", kind: $c1314, required: false, alias: "", example: "", attribute: "on", unless: ""});
const $c1302 = [$c1304, $c1305, $c1306, $c1307, $c1308];
const $c1303 = new Map([["rows", $c1304], ["crown", $c1305], ["factor", $c1306], ["uncertainty", $c1307], ["on", $c1308]]);
const $c1301 = $made(Table, {of: null, entries: $c1302, _known: $c1303});
const $c1299 = $made(TextOr, {text: $c1298, table: $c1301});
const $c934 = $made(Profile, {dimension: "length", diameters: true, rows: $c1298, within: $c1299});
const $c925 = $made(Entry, {key: "worn_depth", kind: $c934, required: false, alias: "", example: "", attribute: "worn_depth", unless: ""});
const $c1362 = $made(Quantity, {dimension: "length", limit: null});
const $c1363 = $made(Quantity, {dimension: "length", limit: null});
const $c1361 = [$c1362, $c1363];
const $c1317 = $made(_Pair, {kinds: $c1361});
const $c1315 = $made(Rows, {kind: $c1317, least: 0, most: 500});
const $c1321 = $made(Entry, {key: "rows", kind: $c1315, required: false, alias: "", example: "", attribute: "rows", unless: ""});
const $c1326 = $made(Quantity, {dimension: "length", limit: null});
const $c1322 = $made(Entry, {key: "crown", kind: $c1326, required: false, alias: "", example: "", attribute: "crown", unless: ""});
const $c1328 = $made(Limit, {dimension: "number", least: 0.0, most: 100.0, open: false, rigid: false});
const $c1327 = $made(Quantity, {dimension: "number", limit: $c1328});
const $c1323 = $made(Entry, {key: "factor", kind: $c1327, required: false, alias: "", example: "", attribute: "factor", unless: ""});
const $c1330 = $made(Limit, {dimension: "length", least: 0.0, most: Infinity, open: false, rigid: false});
const $c1329 = $made(Quantity, {dimension: "length", limit: $c1330});
const $c1324 = $made(Entry, {key: "uncertainty", kind: $c1329, required: false, alias: "", example: "", attribute: "uncertainty", unless: ""});
const $c1331 = $made(Choice, {options: $c1297});
const $c1325 = $made(Entry, {key: "on", kind: $c1331, required: false, alias: "", example: "", attribute: "on", unless: ""});
const $c1319 = [$c1321, $c1322, $c1323, $c1324, $c1325];
const $c1320 = new Map([["rows", $c1321], ["crown", $c1322], ["factor", $c1323], ["uncertainty", $c1324], ["on", $c1325]]);
const $c1318 = $made(Table, {of: null, entries: $c1319, _known: $c1320});
const $c1316 = $made(TextOr, {text: $c1315, table: $c1318});
const $c935 = $made(Profile, {dimension: "length", diameters: true, rows: $c1315, within: $c1316});
const $c926 = $made(Entry, {key: "build_up", kind: $c935, required: false, alias: "", example: "", attribute: "build_up", unless: ""});
const $c937 = $made(Limit, {dimension: "number", least: -0.1, most: 0.1, open: false, rigid: false});
const $c936 = $made(Quantity, {dimension: "number", limit: $c937});
const $c927 = $made(Entry, {key: "misalignment", kind: $c936, required: false, alias: "", example: "", attribute: "misalignment", unless: ""});
const $c939 = $made(Limit, {dimension: "length", least: -0.1, most: 0.1, open: false, rigid: false});
const $c938 = $made(Quantity, {dimension: "length", limit: $c939});
const $c928 = $made(Entry, {key: "deflection", kind: $c938, required: false, alias: "", example: "", attribute: "deflection", unless: ""});
const $c1365 = $made(Quantity, {dimension: "length", limit: null});
const $c1366 = $made(Quantity, {dimension: "force_per_width", limit: null});
const $c1364 = [$c1365, $c1366];
const $c1334 = $made(_Pair, {kinds: $c1364});
const $c1332 = $made(Rows, {kind: $c1334, least: 0, most: 500});
const $c1338 = $made(Entry, {key: "rows", kind: $c1332, required: false, alias: "", example: "", attribute: "rows", unless: ""});
const $c1342 = $made(Quantity, {dimension: "force_per_width", limit: null});
const $c1339 = $made(Entry, {key: "crown", kind: $c1342, required: false, alias: "", example: "", attribute: "crown", unless: ""});
const $c1344 = $made(Limit, {dimension: "number", least: 0.0, most: 100.0, open: false, rigid: false});
const $c1343 = $made(Quantity, {dimension: "number", limit: $c1344});
const $c1340 = $made(Entry, {key: "factor", kind: $c1343, required: false, alias: "", example: "", attribute: "factor", unless: ""});
const $c1346 = $made(Limit, {dimension: "force_per_width", least: 0.0, most: Infinity, open: false, rigid: false});
const $c1345 = $made(Quantity, {dimension: "force_per_width", limit: $c1346});
const $c1341 = $made(Entry, {key: "uncertainty", kind: $c1345, required: false, alias: "", example: "", attribute: "uncertainty", unless: ""});
const $c1336 = [$c1338, $c1339, $c1340, $c1341];
const $c1337 = new Map([["rows", $c1338], ["crown", $c1339], ["factor", $c1340], ["uncertainty", $c1341]]);
const $c1335 = $made(Table, {of: null, entries: $c1336, _known: $c1337});
const $c1333 = $made(TextOr, {text: $c1332, table: $c1335});
const $c940 = $made(Profile, {dimension: "force_per_width", diameters: false, rows: $c1332, within: $c1333});
const $c929 = $made(Entry, {key: "entry_profile", kind: $c940, required: false, alias: "", example: "", attribute: "entry_profile", unless: ""});
const $c950 = ["pulley"];
const $c949 = $made(Choice, {options: $c950});
const $c947 = $made(Entry, {key: "kind", kind: $c949, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c952 = $made(Limit, {dimension: "length", least: 0.0, most: 100000.0, open: true, rigid: false});
const $c951 = $made(Quantity, {dimension: "length", limit: $c952});
const $c948 = $made(Entry, {key: "distance", kind: $c951, required: true, alias: "", example: "", attribute: "distance", unless: ""});
const $c945 = [$c947, $c948];
const $c946 = new Map([["kind", $c947], ["distance", $c948]]);
const $c943 = $made(Table, {of: GrippingPulley, entries: $c945, _known: $c946});
const $c961 = ["transition"];
const $c960 = $made(Choice, {options: $c961});
const $c955 = $made(Entry, {key: "kind", kind: $c960, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c963 = $made(Limit, {dimension: "length", least: 0.0, most: 1000.0, open: true, rigid: false});
const $c962 = $made(Quantity, {dimension: "length", limit: $c963});
const $c956 = $made(Entry, {key: "length", kind: $c962, required: true, alias: "", example: "length = \"2.9 m\"", attribute: "length", unless: ""});
const $c965 = $made(Limit, {dimension: "angle", least: 0.0, most: 1.5707963267948966, open: true, rigid: false});
const $c964 = $made(Quantity, {dimension: "angle", limit: $c965});
const $c957 = $made(Entry, {key: "trough_angle", kind: $c964, required: true, alias: "", example: "trough_angle = \"35 deg\"", attribute: "trough_angle", unless: ""});
const $c967 = $made(Limit, {dimension: "length", least: 0.0, most: 100.0, open: false, rigid: false});
const $c966 = $made(Quantity, {dimension: "length", limit: $c967});
const $c958 = $made(Entry, {key: "centre_roll", kind: $c966, required: true, alias: "", example: "centre_roll = \"465 mm\"", attribute: "centre_roll", unless: ""});
const $c969 = ["full", "half"];
const $c968 = $made(Choice, {options: $c969});
const $c959 = $made(Entry, {key: "depth", kind: $c968, required: false, alias: "", example: "", attribute: "depth", unless: ""});
const $c953 = [$c955, $c956, $c957, $c958, $c959];
const $c954 = new Map([["kind", $c955], ["length", $c956], ["trough_angle", $c957], ["centre_roll", $c958], ["depth", $c959]]);
const $c944 = $made(Table, {of: Transition, entries: $c953, _known: $c954});
const $c942 = new Map([["pulley", $c943], ["transition", $c944]]);
const $c28 = $made(Variant, {tag: "kind", tables: $c942});
const $c941 = $made(WordOr, {word: "far", kind: $c28, meaning: null});
const $c930 = $made(Entry, {key: "before", kind: $c941, required: false, alias: "", example: "", attribute: "before", unless: ""});
const $c977 = ["pulley"];
const $c976 = $made(Choice, {options: $c977});
const $c975 = $made(Entry, {key: "kind", kind: $c976, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c973 = [$c975, $c948];
const $c974 = new Map([["kind", $c975], ["distance", $c948]]);
const $c972 = $made(Table, {of: GrippingPulley, entries: $c973, _known: $c974});
const $c971 = new Map([["pulley", $c972]]);
const $c29 = $made(Variant, {tag: "kind", tables: $c971});
const $c970 = $made(WordOr, {word: "far", kind: $c29, meaning: null});
const $c931 = $made(Entry, {key: "after", kind: $c970, required: false, alias: "", example: "", attribute: "after", unless: ""});
const $c978 = $made(Count, {least: 4, most: 128});
const $c932 = $made(Entry, {key: "strips", kind: $c978, required: false, alias: "", example: "", attribute: "strips", unless: ""});
const $c922 = [$c924, $c925, $c926, $c927, $c928, $c929, $c930, $c931, $c932];
const $c923 = new Map([["shell_profile", $c924], ["worn_depth", $c925], ["build_up", $c926], ["misalignment", $c927], ["deflection", $c928], ["entry_profile", $c929], ["before", $c930], ["after", $c931], ["strips", $c932]]);
const $c30 = $made(Table, {of: Across, entries: $c922, _known: $c923});
const $c152 = $made(Entry, {key: "across", kind: $c30, required: false, alias: "", example: "", attribute: "across", unless: ""});
const $c170 = $made(ByName, {kind: $c2, most: 200});
const $c153 = $made(Entry, {key: "sources", kind: $c170, required: false, alias: "", example: "", attribute: "sources", unless: ""});
const $c9 = [$c136, $c137, $c138, $c139, $c140, $c141, $c142, $c143, $c144, $c145, $c146, $c147, $c148, $c149, $c150, $c151, $c152, $c153];
const $c665 = new Map([["name", $c136], ["diameter", $c137], ["wrap_angle", $c138], ["belt_path", $c139], ["lagging", $c140], ["condition", $c141], ["entry_tension", $c142], ["exit_tension", $c143], ["effective_tension", $c144], ["torque", $c145], ["power", $c146], ["overrun", $c147], ["recovery", $c148], ["creep_limit", $c149], ["side", $c150], ["mass", $c151], ["across", $c152], ["sources", $c153]]);
const $c31 = $made(Table, {of: Pulley, entries: $c9, _known: $c665});
const $c664 = $made(Rows, {kind: $c31, least: 1, most: 10});
const $c628 = $made(Entry, {key: "pulley", kind: $c664, required: true, alias: "", example: "a [[pulley]] table for each pulley", attribute: "pulley", unless: ""});
const $c979 = $made(ByName, {kind: $c689, most: 200});
const $c629 = $made(Entry, {key: "lagging", kind: $c979, required: false, alias: "", example: "", attribute: "lagging", unless: ""});
const $c990 = $made(Name, {longest: 60});
const $c984 = $made(Entry, {key: "name", kind: $c990, required: true, alias: "", example: "name = \"start\"", attribute: "name", unless: ""});
const $c991 = $made(Text, {longest: 1000, lines: true});
const $c985 = $made(Entry, {key: "description", kind: $c991, required: false, alias: "", example: "", attribute: "description", unless: ""});
const $c62 = ["running", "starting", "braking"];
const $c992 = $made(Choice, {options: $c62});
const $c986 = $made(Entry, {key: "kind", kind: $c992, required: false, alias: "", example: "", attribute: "kind", unless: ""});
const $c987 = $made(Entry, {key: "condition", kind: $c159, required: false, alias: "", example: "", attribute: "condition", unless: ""});
const $c995 = [$c142, $c143, $c144, $c145, $c146];
const $c996 = new Map([["entry_tension", $c142], ["exit_tension", $c143], ["effective_tension", $c144], ["torque", $c145], ["power", $c146]]);
const $c994 = $made(Table, {of: null, entries: $c995, _known: $c996});
const $c993 = $made(ByName, {kind: $c994, most: 200});
const $c988 = $made(Entry, {key: "pulley", kind: $c993, required: false, alias: "", example: "", attribute: "pulley", unless: ""});
const $c997 = $made(Elsewhere, {});
const $c989 = $made(Entry, {key: "train", kind: $c997, required: false, alias: "", example: "", attribute: "train", unless: ""});
const $c982 = [$c984, $c985, $c986, $c987, $c988, $c989];
const $c983 = new Map([["name", $c984], ["description", $c985], ["kind", $c986], ["condition", $c987], ["pulley", $c988], ["train", $c989]]);
const $c981 = $made(Table, {of: null, entries: $c982, _known: $c983});
const $c980 = $made(Rows, {kind: $c981, least: 1, most: 1000});
const $c630 = $made(Entry, {key: "load_case", kind: $c980, required: false, alias: "", example: "", attribute: "load_case", unless: ""});
const $c1020 = $made(Limit, {dimension: "length", least: 0.0, most: 100000.0, open: true, rigid: false});
const $c1019 = $made(Quantity, {dimension: "length", limit: $c1020});
const $c1000 = $made(Entry, {key: "length", kind: $c1019, required: true, alias: "", example: "length = \"600 m\"", attribute: "length", unless: ""});
const $c1022 = $made(Limit, {dimension: "length", least: -5000.0, most: 5000.0, open: false, rigid: false});
const $c1021 = $made(Quantity, {dimension: "length", limit: $c1022});
const $c1001 = $made(Entry, {key: "lift", kind: $c1021, required: false, alias: "", example: "", attribute: "lift", unless: ""});
const $c1024 = $made(Limit, {dimension: "mass_per_length", least: 0.0, most: 10000.0, open: true, rigid: false});
const $c1023 = $made(Quantity, {dimension: "mass_per_length", limit: $c1024});
const $c1002 = $made(Entry, {key: "belt_mass", kind: $c1023, required: true, alias: "", example: "", attribute: "belt_mass", unless: ""});
const $c1026 = $made(Limit, {dimension: "mass_per_length", least: 0.0, most: 10000.0, open: false, rigid: false});
const $c1025 = $made(Quantity, {dimension: "mass_per_length", limit: $c1026});
const $c1003 = $made(Entry, {key: "carry_idler_mass", kind: $c1025, required: true, alias: "", example: "", attribute: "carry_idler_mass", unless: ""});
const $c1028 = $made(Limit, {dimension: "mass_per_length", least: 0.0, most: 10000.0, open: false, rigid: false});
const $c1027 = $made(Quantity, {dimension: "mass_per_length", limit: $c1028});
const $c1004 = $made(Entry, {key: "return_idler_mass", kind: $c1027, required: true, alias: "", example: "", attribute: "return_idler_mass", unless: ""});
const $c1029 = $made(Quantity, {dimension: "mass_per_length", limit: $c1024});
const $c1005 = $made(Entry, {key: "material_mass", kind: $c1029, required: false, alias: "", example: "", attribute: "material_mass", unless: ""});
const $c1031 = $made(Limit, {dimension: "mass_flow", least: 0.0, most: 100000.0, open: true, rigid: false});
const $c1030 = $made(Quantity, {dimension: "mass_flow", limit: $c1031});
const $c1006 = $made(Entry, {key: "capacity", kind: $c1030, required: false, alias: "", example: "", attribute: "capacity", unless: ""});
const $c1033 = $made(Limit, {dimension: "number", least: 0.005, most: 0.1, open: false, rigid: false});
const $c1032 = $made(Quantity, {dimension: "number", limit: $c1033});
const $c1007 = $made(Entry, {key: "friction_factor", kind: $c1032, required: false, alias: "", example: "", attribute: "friction_factor", unless: ""});
const $c1035 = $made(Limit, {dimension: "number", least: 1.0, most: 10.0, open: false, rigid: false});
const $c1034 = $made(Quantity, {dimension: "number", limit: $c1035});
const $c1008 = $made(Entry, {key: "length_coefficient", kind: $c1034, required: false, alias: "", example: "", attribute: "length_coefficient", unless: ""});
const $c1037 = $made(Limit, {dimension: "force", least: 0.0, most: 100000000.0, open: false, rigid: false});
const $c1036 = $made(Quantity, {dimension: "force", limit: $c1037});
const $c1009 = $made(Entry, {key: "secondary_resistance", kind: $c1036, required: false, alias: "", example: "", attribute: "secondary_resistance", unless: ""});
const $c1038 = $made(Quantity, {dimension: "force", limit: $c1037});
const $c1010 = $made(Entry, {key: "special_resistance", kind: $c1038, required: false, alias: "", example: "", attribute: "special_resistance", unless: ""});
const $c1040 = $made(Limit, {dimension: "number", least: 0.0, most: 1.0, open: false, rigid: false});
const $c1039 = $made(Quantity, {dimension: "number", limit: $c1040});
const $c1011 = $made(Entry, {key: "return_share", kind: $c1039, required: false, alias: "", example: "", attribute: "return_share", unless: ""});
const $c1042 = $made(Limit, {dimension: "number", least: 1.0, most: 5.0, open: false, rigid: false});
const $c1041 = $made(Quantity, {dimension: "number", limit: $c1042});
const $c1012 = $made(Entry, {key: "start_factor", kind: $c1041, required: false, alias: "", example: "", attribute: "start_factor", unless: ""});
const $c1044 = $made(Limit, {dimension: "time", least: 0.0, most: 3600.0, open: true, rigid: false});
const $c1043 = $made(Quantity, {dimension: "time", limit: $c1044});
const $c1013 = $made(Entry, {key: "start_time", kind: $c1043, required: false, alias: "", example: "", attribute: "start_time", unless: ""});
const $c1045 = $made(Quantity, {dimension: "time", limit: $c1044});
const $c1014 = $made(Entry, {key: "stop_time", kind: $c1045, required: false, alias: "", example: "", attribute: "stop_time", unless: ""});
const $c1047 = $made(Limit, {dimension: "force", least: 0.0, most: 100000000.0, open: true, rigid: false});
const $c1046 = $made(Quantity, {dimension: "force", limit: $c1047});
const $c1015 = $made(Entry, {key: "take_up_tension", kind: $c1046, required: false, alias: "", example: "", attribute: "take_up_tension", unless: ""});
const $c1049 = $made(Limit, {dimension: "mass", least: 0.0, most: 10000000.0, open: true, rigid: false});
const $c1048 = $made(Quantity, {dimension: "mass", limit: $c1049});
const $c1016 = $made(Entry, {key: "counterweight", kind: $c1048, required: false, alias: "", example: "", attribute: "counterweight", unless: ""});
const $c1051 = $made(Limit, {dimension: "length", least: 0.0, most: 100000.0, open: false, rigid: false});
const $c1050 = $made(Quantity, {dimension: "length", limit: $c1051});
const $c1017 = $made(Entry, {key: "take_up_distance", kind: $c1050, required: false, alias: "", example: "", attribute: "take_up_distance", unless: ""});
const $c604 = ["head", "tail"];
const $c1052 = $made(Choice, {options: $c604});
const $c1018 = $made(Entry, {key: "drive_at", kind: $c1052, required: false, alias: "", example: "", attribute: "drive_at", unless: ""});
const $c998 = [$c1000, $c1001, $c1002, $c1003, $c1004, $c1005, $c1006, $c1007, $c1008, $c1009, $c1010, $c1011, $c1012, $c1013, $c1014, $c1015, $c1016, $c1017, $c1018];
const $c999 = new Map([["length", $c1000], ["lift", $c1001], ["belt_mass", $c1002], ["carry_idler_mass", $c1003], ["return_idler_mass", $c1004], ["material_mass", $c1005], ["capacity", $c1006], ["friction_factor", $c1007], ["length_coefficient", $c1008], ["secondary_resistance", $c1009], ["special_resistance", $c1010], ["return_share", $c1011], ["start_factor", $c1012], ["start_time", $c1013], ["stop_time", $c1014], ["take_up_tension", $c1015], ["counterweight", $c1016], ["take_up_distance", $c1017], ["drive_at", $c1018]]);
const $c37 = $made(Table, {of: Conveyor, entries: $c998, _known: $c999});
const $c631 = $made(Entry, {key: "conveyor", kind: $c37, required: false, alias: "", example: "", attribute: "conveyor", unless: ""});
const $c598 = ["gravity", "winch", "fixed"];
const $c1058 = $made(Choice, {options: $c598});
const $c1055 = $made(Entry, {key: "kind", kind: $c1058, required: false, alias: "", example: "", attribute: "kind", unless: ""});
const $c593 = $made(Limit, {dimension: "number", least: 0.01, most: 100.0, open: false, rigid: false});
const $c1059 = $made(Quantity, {dimension: "number", limit: $c593});
const $c1056 = $made(Entry, {key: "sheave_ratio", kind: $c1059, required: false, alias: "", example: "", attribute: "sheave_ratio", unless: ""});
const $c1060 = $made(Name, {longest: 60});
const $c1057 = $made(Entry, {key: "after", kind: $c1060, required: false, alias: "", example: "", attribute: "after", unless: ""});
const $c1053 = [$c1055, $c1056, $c1057];
const $c1054 = new Map([["kind", $c1055], ["sheave_ratio", $c1056], ["after", $c1057]]);
const $c499 = $made(Table, {of: TakeUp, entries: $c1053, _known: $c1054});
const $c495 = $made(Entry, {key: "take_up", kind: $c499, required: false, alias: "", example: "", attribute: "take_up", unless: ""});
const $c599 = ["CEMA", "DIN 22101", "own", "none"];
const $c1068 = $made(Choice, {options: $c599});
const $c1063 = $made(Entry, {key: "name", kind: $c1068, required: false, alias: "", example: "", attribute: "name", unless: ""});
const $c600 = ["dry", "wet", "wet and dirty"];
const $c1069 = $made(Choice, {options: $c600});
const $c1064 = $made(Entry, {key: "condition", kind: $c1069, required: false, alias: "", example: "", attribute: "condition", unless: ""});
const $c594 = $made(Limit, {dimension: "number", least: 0.01, most: 2.0, open: false, rigid: false});
const $c1070 = $made(Quantity, {dimension: "number", limit: $c594});
const $c1065 = $made(Entry, {key: "friction", kind: $c1070, required: false, alias: "", example: "", attribute: "friction", unless: ""});
const $c595 = $made(Limit, {dimension: "number", least: 1.0, most: 10.0, open: false, rigid: false});
const $c1071 = $made(Quantity, {dimension: "number", limit: $c595});
const $c1066 = $made(Entry, {key: "start_factor", kind: $c1071, required: false, alias: "", example: "", attribute: "start_factor", unless: ""});
const $c1072 = $made(Flag, {});
const $c1067 = $made(Entry, {key: "binding", kind: $c1072, required: false, alias: "", example: "", attribute: "binding", unless: ""});
const $c1061 = [$c1063, $c1064, $c1065, $c1066, $c1067];
const $c1062 = new Map([["name", $c1063], ["condition", $c1064], ["friction", $c1065], ["start_factor", $c1066], ["binding", $c1067]]);
const $c500 = $made(Table, {of: DesignStandard, entries: $c1061, _known: $c1062});
const $c496 = $made(Entry, {key: "design_standard", kind: $c500, required: false, alias: "", example: "", attribute: "standard", unless: ""});
const $c1079 = $made(Quantity, {dimension: "number", limit: $c595});
const $c1075 = $made(Entry, {key: "running", kind: $c1079, required: false, alias: "", example: "", attribute: "running", unless: ""});
const $c1080 = $made(Quantity, {dimension: "number", limit: $c595});
const $c1076 = $made(Entry, {key: "starting", kind: $c1080, required: false, alias: "", example: "", attribute: "starting", unless: ""});
const $c1081 = $made(Quantity, {dimension: "number", limit: $c595});
const $c1077 = $made(Entry, {key: "braking", kind: $c1081, required: false, alias: "", example: "", attribute: "braking", unless: ""});
const $c1082 = $made(Text, {longest: 500, lines: false});
const $c1078 = $made(Entry, {key: "source", kind: $c1082, required: false, alias: "", example: "", attribute: "source", unless: ""});
const $c1073 = [$c1075, $c1076, $c1077, $c1078];
const $c1074 = new Map([["running", $c1075], ["starting", $c1076], ["braking", $c1077], ["source", $c1078]]);
const $c501 = $made(Table, {of: SafetyFactors, entries: $c1073, _known: $c1074});
const $c497 = $made(Entry, {key: "safety_factor", kind: $c501, required: false, alias: "", example: "", attribute: "safety", unless: ""});
const $c1089 = $made(Limit, {dimension: "length", least: 0.0, most: 100.0, open: true, rigid: false});
const $c1088 = $made(Quantity, {dimension: "length", limit: $c1089});
const $c1085 = $made(Entry, {key: "idler_spacing", kind: $c1088, required: true, alias: "", example: "idler_spacing = \"3 m\"", attribute: "spacing", unless: ""});
const $c1091 = $made(Limit, {dimension: "mass_per_length", least: 0.0, most: 10000.0, open: true, rigid: false});
const $c1090 = $made(Quantity, {dimension: "mass_per_length", limit: $c1091});
const $c1086 = $made(Entry, {key: "line_mass", kind: $c1090, required: true, alias: "", example: "line_mass = \"22 kg/m\"", attribute: "line_mass", unless: ""});
const $c1093 = $made(Limit, {dimension: "number", least: 0.0, most: 0.1, open: true, rigid: false});
const $c1092 = $made(Quantity, {dimension: "number", limit: $c1093});
const $c1087 = $made(Entry, {key: "share", kind: $c1092, required: false, alias: "", example: "", attribute: "share", unless: ""});
const $c1083 = [$c1085, $c1086, $c1087];
const $c1084 = new Map([["idler_spacing", $c1085], ["line_mass", $c1086], ["share", $c1087]]);
const $c502 = $made(Table, {of: Sag, entries: $c1083, _known: $c1084});
const $c498 = $made(Entry, {key: "sag", kind: $c502, required: false, alias: "", example: "", attribute: "sag", unless: ""});
const $c1094 = $made(Elsewhere, {});
const $c632 = $made(Entry, {key: "train", kind: $c1094, required: false, alias: "", example: "", attribute: "train", unless: ""});
const $c1095 = $made(Elsewhere, {});
const $c633 = $made(Entry, {key: "motion", kind: $c1095, required: false, alias: "", example: "", attribute: "motion", unless: ""});
const $c620 = [$c622, $c623, $c624, $c625, $c626, $c627, $c628, $c629, $c630, $c631, $c495, $c496, $c497, $c498, $c632, $c633];
const $c621 = new Map([["format", $c622], ["title", $c623], ["description", $c624], ["creep_limit", $c625], ["condition", $c626], ["belt", $c627], ["pulley", $c628], ["lagging", $c629], ["load_case", $c630], ["conveyor", $c631], ["take_up", $c495], ["design_standard", $c496], ["safety_factor", $c497], ["sag", $c498], ["train", $c632], ["motion", $c633]]);
const $c0 = $made(Table, {of: Drive, entries: $c620, _known: $c621});
const $c3 = ["name", "kind", "modulus", "rating", "least_pulley_diameter", "carcass"];
const $c4 = new Map([["width", $c121], ["modulus", $c122], ["rating", $c123], ["strength", $c124], ["speed", $c125], ["momentary_factor", $c126], ["least_pulley_diameter", $c127], ["largest_wrap_pressure", $c128], ["in_plane_shear_stiffness", $c129], ["pulley_cover", $c130], ["carry_cover", $c131], ["carcass", $c132], ["thickness", $c133], ["cover_shear_modulus", $c134], ["mass", $c135]]);
const $c6 = ["pulley_cover", "carry_cover", "carcass"];
const $c7 = $made(_Nothing, {});
const $c10 = ["x", "y", "diameter", "turn"];
const $c196 = [10000, "m"];
const $c195 = [$c196];
const $c173 = ["mm", $c195];
const $c174 = ["kN", []];
const $c175 = ["kN/m", []];
const $c198 = [10000, "MPa"];
const $c197 = [$c198];
const $c176 = ["kPa", $c197];
const $c177 = ["kPa/mm", []];
const $c178 = ["m/s", []];
const $c179 = ["deg", []];
const $c180 = ["kW", []];
const $c181 = ["kN m", []];
const $c182 = ["m2", []];
const $c183 = ["s", []];
const $c184 = ["degC", []];
const $c185 = ["1/mm", []];
const $c186 = ["mm3/J", []];
const $c187 = ["J/m2", []];
const $c200 = [10000, "kW/m2"];
const $c199 = [$c200];
const $c188 = ["W/m2", $c199];
const $c189 = ["rpm", []];
const $c190 = ["kg", []];
const $c191 = ["kg/m", []];
const $c192 = ["t/h", []];
const $c193 = ["kg m2", []];
const $c194 = ["", []];
const $c171 = new Map([["length", $c173], ["force", $c174], ["force_per_width", $c175], ["spring_rate", $c175], ["pressure", $c176], ["pressure_per_length", $c177], ["speed", $c178], ["angle", $c179], ["power", $c180], ["torque", $c181], ["area", $c182], ["time", $c183], ["temperature", $c184], ["per_length", $c185], ["wear_coefficient", $c186], ["energy_per_area", $c187], ["power_per_area", $c188], ["rotation_speed", $c189], ["mass", $c190], ["mass_per_length", $c191], ["mass_flow", $c192], ["moment_of_inertia", $c193], ["number", $c194]]);
const $c221 = [400, "ft"];
const $c220 = [$c221];
const $c201 = ["in", $c220];
const $c202 = ["lbf", []];
const $c203 = ["PIW", []];
const $c204 = ["lbf/in", []];
const $c223 = [10000, "ksi"];
const $c222 = [$c223];
const $c205 = ["psi", $c222];
const $c206 = ["psi/in", []];
const $c207 = ["fpm", []];
const $c208 = ["hp", []];
const $c209 = ["lbf ft", []];
const $c210 = ["in2", []];
const $c211 = ["degF", []];
const $c212 = ["1/in", []];
const $c213 = ["in3/(ft lbf)", []];
const $c214 = ["ft lbf/ft2", []];
const $c215 = ["hp/ft2", []];
const $c216 = ["lbm", []];
const $c217 = ["lbm/ft", []];
const $c218 = ["lbm/h", []];
const $c219 = ["lbm ft2", []];
const $c172 = new Map([["length", $c201], ["force", $c202], ["force_per_width", $c203], ["spring_rate", $c204], ["pressure", $c205], ["pressure_per_length", $c206], ["speed", $c207], ["angle", $c179], ["power", $c208], ["torque", $c209], ["area", $c210], ["time", $c183], ["temperature", $c211], ["per_length", $c212], ["wear_coefficient", $c213], ["energy_per_area", $c214], ["power_per_area", $c215], ["rotation_speed", $c189], ["mass", $c216], ["mass_per_length", $c217], ["mass_flow", $c218], ["moment_of_inertia", $c219], ["number", $c194]]);
const $c11 = new Map([["si", $c171], ["us", $c172]]);
const $c224 = new DimensionText("m", "a length", "1200 mm");
const $c225 = new DimensionText("N", "a force", "150 kN");
const $c226 = new DimensionText("N/m", "a force per width", "12960 kN/m");
const $c227 = new DimensionText("N/m", "a spring rate", "12000 kN/m");
const $c228 = new DimensionText("Pa", "a pressure", "200 kPa");
const $c229 = new DimensionText("Pa/m", "a pressure per length", "190 kPa/mm");
const $c230 = new DimensionText("m/s", "a speed", "3 m/s");
const $c231 = new DimensionText("rad", "an angle", "180 deg");
const $c232 = new DimensionText("W", "a power", "250 kW");
const $c233 = new DimensionText("N m", "a torque", "40 kN m");
const $c234 = new DimensionText("m2", "an area", "2500 mm2");
const $c235 = new DimensionText("s", "a time", "10 s");
const $c236 = new DimensionText("K", "a temperature", "20 degC");
const $c237 = new DimensionText("1/m", "a value per length", "-0.016 1/mm");
const $c238 = new DimensionText("m3/J", "a wear volume per energy", "0.05 mm3/J");
const $c239 = new DimensionText("J/m2", "an energy per area", "800 J/m2");
const $c240 = new DimensionText("W/m2", "a power per area", "1500 W/m2");
const $c241 = new DimensionText("rad/s", "a rotation speed", "71.6 rpm");
const $c242 = new DimensionText("kg", "a mass", "500 kg");
const $c243 = new DimensionText("kg/m", "a mass per length", "22 kg/m");
const $c244 = new DimensionText("kg/s", "a mass flow", "1500 t/h");
const $c245 = new DimensionText("kg m2", "a moment of inertia", "2200 kg m2");
const $c246 = new DimensionText("", "a plain number", "0.35");
const $c12 = new Map([["length", $c224], ["force", $c225], ["force_per_width", $c226], ["spring_rate", $c227], ["pressure", $c228], ["pressure_per_length", $c229], ["speed", $c230], ["angle", $c231], ["power", $c232], ["torque", $c233], ["area", $c234], ["time", $c235], ["temperature", $c236], ["per_length", $c237], ["wear_coefficient", $c238], ["energy_per_area", $c239], ["power_per_area", $c240], ["rotation_speed", $c241], ["mass", $c242], ["mass_per_length", $c243], ["mass_flow", $c244], ["moment_of_inertia", $c245], ["number", $c246]]);
const $c13 = $re("[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?", "");
const $c14 = $re("[0-9.,'’_´`\\s+\\-−/:;]*(?:(?<=[0-9])[eE][+-]?[0-9]+)?", "");
const $c15 = $re("[+-]?\\s*(?:nan|inf|infinity|∞)\\b", "i");
const $c16 = $re("[eE][+-]?([0-9]+)$", "");
const $c17 = $re("(?<=[0-9])[\\s'’_´`]+(?=[0-9])", "");
const $c18 = $re("[,.]", "");
const $c19 = $re("1\\s*/\\s*[A-Za-z(]", "");
const $c20 = $re("[0-9.,'’_´`+\\-−:;]|/\\s*[0-9]", "");
const $c21 = ["kg", "m", "s", "K", "rad"];
const $c309 = ["meter", "meters", "metre", "metres"];
const $c310 = $Decimal.of("1");
const $c311 = $Decimal.of("0");
const $c247 = new Definition($c309, $c310, "m", $c311);
const $c312 = ["km"];
const $c313 = $Decimal.of("1000");
const $c314 = $Decimal.of("0");
const $c248 = new Definition($c312, $c313, "m", $c314);
const $c315 = ["dm"];
const $c316 = $Decimal.of("0.1");
const $c317 = $Decimal.of("0");
const $c249 = new Definition($c315, $c316, "m", $c317);
const $c318 = ["cm"];
const $c319 = $Decimal.of("0.01");
const $c320 = $Decimal.of("0");
const $c250 = new Definition($c318, $c319, "m", $c320);
const $c321 = ["mm"];
const $c322 = $Decimal.of("0.001");
const $c323 = $Decimal.of("0");
const $c251 = new Definition($c321, $c322, "m", $c323);
const $c324 = ["um", "micron", "microns"];
const $c325 = $Decimal.of("0.000001");
const $c326 = $Decimal.of("0");
const $c252 = new Definition($c324, $c325, "m", $c326);
const $c327 = ["in", "inch", "inches", "\""];
const $c328 = $Decimal.of("0.0254");
const $c329 = $Decimal.of("0");
const $c253 = new Definition($c327, $c328, "m", $c329);
const $c330 = ["ft", "foot", "feet"];
const $c331 = $Decimal.of("12");
const $c332 = $Decimal.of("0");
const $c254 = new Definition($c330, $c331, "in", $c332);
const $c333 = ["yd"];
const $c334 = $Decimal.of("3");
const $c335 = $Decimal.of("0");
const $c255 = new Definition($c333, $c334, "ft", $c335);
const $c336 = ["mi", "mile", "miles"];
const $c337 = $Decimal.of("5280");
const $c338 = $Decimal.of("0");
const $c256 = new Definition($c336, $c337, "ft", $c338);
const $c339 = ["thou"];
const $c340 = $Decimal.of("0.001");
const $c341 = $Decimal.of("0");
const $c257 = new Definition($c339, $c340, "in", $c341);
const $c342 = ["g"];
const $c343 = $Decimal.of("0.001");
const $c344 = $Decimal.of("0");
const $c258 = new Definition($c342, $c343, "kg", $c344);
const $c345 = ["t", "tonne", "tonnes"];
const $c346 = $Decimal.of("1000");
const $c347 = $Decimal.of("0");
const $c259 = new Definition($c345, $c346, "kg", $c347);
const $c348 = ["lbm"];
const $c349 = $Decimal.of("0.45359237");
const $c350 = $Decimal.of("0");
const $c260 = new Definition($c348, $c349, "kg", $c350);
const $c351 = ["sec", "second", "seconds"];
const $c352 = $Decimal.of("1");
const $c353 = $Decimal.of("0");
const $c261 = new Definition($c351, $c352, "s", $c353);
const $c354 = ["ms"];
const $c355 = $Decimal.of("0.001");
const $c356 = $Decimal.of("0");
const $c262 = new Definition($c354, $c355, "s", $c356);
const $c357 = ["min", "minute", "minutes"];
const $c358 = $Decimal.of("60");
const $c359 = $Decimal.of("0");
const $c263 = new Definition($c357, $c358, "s", $c359);
const $c360 = ["h", "hr", "hour", "hours"];
const $c361 = $Decimal.of("60");
const $c362 = $Decimal.of("0");
const $c264 = new Definition($c360, $c361, "min", $c362);
const $c363 = ["d", "day", "days"];
const $c364 = $Decimal.of("24");
const $c365 = $Decimal.of("0");
const $c265 = new Definition($c363, $c364, "h", $c365);
const $c366 = ["N", "newton", "newtons"];
const $c367 = $Decimal.of("1");
const $c368 = $Decimal.of("0");
const $c266 = new Definition($c366, $c367, "kg m/s2", $c368);
const $c369 = ["mN"];
const $c370 = $Decimal.of("0.001");
const $c371 = $Decimal.of("0");
const $c267 = new Definition($c369, $c370, "N", $c371);
const $c372 = ["daN"];
const $c373 = $Decimal.of("10");
const $c374 = $Decimal.of("0");
const $c268 = new Definition($c372, $c373, "N", $c374);
const $c375 = ["kN"];
const $c376 = $Decimal.of("1000");
const $c377 = $Decimal.of("0");
const $c269 = new Definition($c375, $c376, "N", $c377);
const $c378 = ["MN"];
const $c379 = $Decimal.of("1E+6");
const $c380 = $Decimal.of("0");
const $c270 = new Definition($c378, $c379, "N", $c380);
const $c381 = ["kgf", "kp"];
const $c382 = $Decimal.of("9.80665");
const $c383 = $Decimal.of("0");
const $c271 = new Definition($c381, $c382, "N", $c383);
const $c384 = ["gf"];
const $c385 = $Decimal.of("0.001");
const $c386 = $Decimal.of("0");
const $c272 = new Definition($c384, $c385, "kgf", $c386);
const $c387 = ["tf"];
const $c388 = $Decimal.of("1000");
const $c389 = $Decimal.of("0");
const $c273 = new Definition($c387, $c388, "kgf", $c389);
const $c390 = ["lbf", "lb", "lbs"];
const $c391 = $Decimal.of("4.4482216152605");
const $c392 = $Decimal.of("0");
const $c274 = new Definition($c390, $c391, "N", $c392);
const $c393 = ["klbf", "kip", "kips"];
const $c394 = $Decimal.of("1000");
const $c395 = $Decimal.of("0");
const $c275 = new Definition($c393, $c394, "lbf", $c395);
const $c396 = ["PIW", "piw", "PLI", "pli"];
const $c397 = $Decimal.of("1");
const $c398 = $Decimal.of("0");
const $c276 = new Definition($c396, $c397, "lbf/in", $c398);
const $c399 = ["Pa"];
const $c400 = $Decimal.of("1");
const $c401 = $Decimal.of("0");
const $c277 = new Definition($c399, $c400, "N/m2", $c401);
const $c402 = ["hPa"];
const $c403 = $Decimal.of("100");
const $c404 = $Decimal.of("0");
const $c278 = new Definition($c402, $c403, "Pa", $c404);
const $c405 = ["kPa"];
const $c406 = $Decimal.of("1000");
const $c407 = $Decimal.of("0");
const $c279 = new Definition($c405, $c406, "Pa", $c407);
const $c408 = ["MPa"];
const $c409 = $Decimal.of("1E+6");
const $c410 = $Decimal.of("0");
const $c280 = new Definition($c408, $c409, "Pa", $c410);
const $c411 = ["GPa"];
const $c412 = $Decimal.of("1E+9");
const $c413 = $Decimal.of("0");
const $c281 = new Definition($c411, $c412, "Pa", $c413);
const $c414 = ["bar"];
const $c415 = $Decimal.of("1E+5");
const $c416 = $Decimal.of("0");
const $c282 = new Definition($c414, $c415, "Pa", $c416);
const $c417 = ["mbar"];
const $c418 = $Decimal.of("100");
const $c419 = $Decimal.of("0");
const $c283 = new Definition($c417, $c418, "Pa", $c419);
const $c420 = ["psi", "PSI"];
const $c421 = $Decimal.of("1");
const $c422 = $Decimal.of("0");
const $c284 = new Definition($c420, $c421, "lbf/in2", $c422);
const $c423 = ["ksi"];
const $c424 = $Decimal.of("1000");
const $c425 = $Decimal.of("0");
const $c285 = new Definition($c423, $c424, "psi", $c425);
const $c426 = ["J", "joule"];
const $c427 = $Decimal.of("1");
const $c428 = $Decimal.of("0");
const $c286 = new Definition($c426, $c427, "N m", $c428);
const $c429 = ["mJ"];
const $c430 = $Decimal.of("0.001");
const $c431 = $Decimal.of("0");
const $c287 = new Definition($c429, $c430, "J", $c431);
const $c432 = ["kJ"];
const $c433 = $Decimal.of("1000");
const $c434 = $Decimal.of("0");
const $c288 = new Definition($c432, $c433, "J", $c434);
const $c435 = ["MJ"];
const $c436 = $Decimal.of("1E+6");
const $c437 = $Decimal.of("0");
const $c289 = new Definition($c435, $c436, "J", $c437);
const $c438 = ["Nm"];
const $c439 = $Decimal.of("1");
const $c440 = $Decimal.of("0");
const $c290 = new Definition($c438, $c439, "N m", $c440);
const $c441 = ["kNm"];
const $c442 = $Decimal.of("1000");
const $c443 = $Decimal.of("0");
const $c291 = new Definition($c441, $c442, "N m", $c443);
const $c444 = ["MNm"];
const $c445 = $Decimal.of("1E+6");
const $c446 = $Decimal.of("0");
const $c292 = new Definition($c444, $c445, "N m", $c446);
const $c447 = ["W", "watt", "watts"];
const $c448 = $Decimal.of("1");
const $c449 = $Decimal.of("0");
const $c293 = new Definition($c447, $c448, "J/s", $c449);
const $c450 = ["kW"];
const $c451 = $Decimal.of("1000");
const $c452 = $Decimal.of("0");
const $c294 = new Definition($c450, $c451, "W", $c452);
const $c453 = ["MW"];
const $c454 = $Decimal.of("1E+6");
const $c455 = $Decimal.of("0");
const $c295 = new Definition($c453, $c454, "W", $c455);
const $c456 = ["hp", "HP", "bhp", "BHP"];
const $c457 = $Decimal.of("550");
const $c458 = $Decimal.of("0");
const $c296 = new Definition($c456, $c457, "ft lbf/s", $c458);
const $c459 = ["PS", "cv", "CV", "hp(metric)"];
const $c460 = $Decimal.of("75");
const $c461 = $Decimal.of("0");
const $c297 = new Definition($c459, $c460, "kgf m/s", $c461);
const $c462 = ["fpm", "FPM"];
const $c463 = $Decimal.of("1");
const $c464 = $Decimal.of("0");
const $c298 = new Definition($c462, $c463, "ft/min", $c464);
const $c465 = ["fps"];
const $c466 = $Decimal.of("1");
const $c467 = $Decimal.of("0");
const $c299 = new Definition($c465, $c466, "ft/s", $c467);
const $c468 = ["kph", "kmh"];
const $c469 = $Decimal.of("1");
const $c470 = $Decimal.of("0");
const $c300 = new Definition($c468, $c469, "km/h", $c470);
const $c471 = ["mph"];
const $c472 = $Decimal.of("1");
const $c473 = $Decimal.of("0");
const $c301 = new Definition($c471, $c472, "mi/h", $c473);
const $c474 = ["mrad"];
const $c475 = $Decimal.of("0.001");
const $c476 = $Decimal.of("0");
const $c302 = new Definition($c474, $c475, "rad", $c476);
const $c477 = ["deg", "degree", "degrees", "°"];
const $c478 = $Decimal.of("0.01745329251994329576923690768");
const $c479 = $Decimal.of("0");
const $c303 = new Definition($c477, $c478, "rad", $c479);
const $c480 = ["rev", "turn", "turns"];
const $c481 = $Decimal.of("360");
const $c482 = $Decimal.of("0");
const $c304 = new Definition($c480, $c481, "deg", $c482);
const $c483 = ["rpm", "RPM"];
const $c484 = $Decimal.of("1");
const $c485 = $Decimal.of("0");
const $c305 = new Definition($c483, $c484, "rev/min", $c485);
const $c486 = ["degC", "°C"];
const $c487 = $Decimal.of("1");
const $c488 = $Decimal.of("-273.15");
const $c306 = new Definition($c486, $c487, "K", $c488);
const $c489 = ["degF", "°F"];
const $c490 = $Decimal.of("0.5555555555555555555555555556");
const $c491 = $Decimal.of("-459.67");
const $c307 = new Definition($c489, $c490, "K", $c491);
const $c492 = ["%", "percent"];
const $c493 = $Decimal.of("0.01");
const $c494 = $Decimal.of("0");
const $c308 = new Definition($c492, $c493, "", $c494);
const $c22 = [$c247, $c248, $c249, $c250, $c251, $c252, $c253, $c254, $c255, $c256, $c257, $c258, $c259, $c260, $c261, $c262, $c263, $c264, $c265, $c266, $c267, $c268, $c269, $c270, $c271, $c272, $c273, $c274, $c275, $c276, $c277, $c278, $c279, $c280, $c281, $c282, $c283, $c284, $c285, $c286, $c287, $c288, $c289, $c290, $c291, $c292, $c293, $c294, $c295, $c296, $c297, $c298, $c299, $c300, $c301, $c302, $c303, $c304, $c305, $c306, $c307, $c308];
const $c23 = new Map([[181, "u"], [956, "u"], [8243, "\""], [8221, "\""], [186, "°"], [183, "*"], [8901, "*"], [215, "*"], [178, "2"], [179, "3"], [8315, "-"], [185, "1"], [160, " "], [8239, " "]]);
const $c24 = $re("(?<over>1|[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)?\\s*(?:/\\s*(?:(?<one>[A-Za-z°%\"]+(?:\\^?-?[1-9])?)|\\(\\s*(?<under>[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)\\s*\\)))?", "");
const $c25 = $re("([A-Za-z°%\"]+)(?:\\^?(-?[1-9]))?", "");
const $c26 = ["length", "force", "force_per_width", "spring_rate", "pressure", "pressure_per_length", "speed", "angle", "power", "torque", "area", "time", "temperature", "per_length", "wear_coefficient", "energy_per_area", "power_per_area", "rotation_speed", "mass", "mass_per_length", "mass_flow", "moment_of_inertia", "number"];
const $c27 = $made(Provenance, {kind: "given", source: "", date: "", note: "from the coordinates of the pulleys"});
const $c32 = [$c495, $c496, $c497, $c498];
const $c33 = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
const $c34 = ["effective_tension", "torque", "power"];
const $c35 = ["entry_tension", "exit_tension"];
const $c36 = new Map([["entry", "entry_tension"], ["exit", "exit_tension"]]);
const $c503 = ["material_mass", "capacity", "material_mass = \"120 kg/m\""];
const $c504 = ["take_up_tension", "counterweight", "take_up_tension = \"40 kN\""];
const $c505 = ["length_coefficient", "secondary_resistance", ""];
const $c506 = ["start_factor", "start_time", ""];
const $c38 = [$c503, $c504, $c505, $c506];
const $c39 = ["capacity", "start_time", "stop_time"];
const $c1115 = $made(Quantity, {dimension: "force", limit: $c580});
const $c1108 = $made(Entry, {key: "entry_tension", kind: $c1115, required: false, alias: "", example: "", attribute: "entry_tension", unless: ""});
const $c1109 = $made(Entry, {key: "exit_tension", kind: $c1115, required: false, alias: "", example: "", attribute: "exit_tension", unless: ""});
const $c1116 = $made(Quantity, {dimension: "force", limit: null});
const $c1110 = $made(Entry, {key: "effective_tension", kind: $c1116, required: false, alias: "", example: "", attribute: "effective_tension", unless: ""});
const $c1117 = $made(Quantity, {dimension: "power", limit: null});
const $c1111 = $made(Entry, {key: "power", kind: $c1117, required: false, alias: "", example: "", attribute: "power", unless: ""});
const $c1119 = $made(Quantity, {dimension: "force", limit: null});
const $c1118 = $made(ByName, {kind: $c1119, most: 200});
const $c1112 = $made(Entry, {key: "run", kind: $c1118, required: false, alias: "", example: "", attribute: "run", unless: ""});
const $c1349 = $made(Limit, {dimension: "number", least: -100.0, most: 100.0, open: false, rigid: false});
const $c1347 = $made(Quantity, {dimension: "number", limit: $c1349});
const $c1348 = $made(Quantity, {dimension: "power", limit: null});
const $c1121 = $made(Either, {first: $c1347, second: $c1348, words: "a share like 0.5 or \"50 %\", or a power like \"300 kW\""});
const $c1120 = $made(Rows, {kind: $c1121, least: 1, most: 10});
const $c1113 = $made(Entry, {key: "share", kind: $c1120, required: false, alias: "", example: "", attribute: "share", unless: ""});
const $c1122 = $made(SpeedList, {});
const $c1114 = $made(Entry, {key: "speeds", kind: $c1122, required: false, alias: "", example: "", attribute: "speeds", unless: ""});
const $c1106 = [$c1108, $c1109, $c1110, $c1111, $c1112, $c1113, $c1114];
const $c1107 = new Map([["entry_tension", $c1108], ["exit_tension", $c1109], ["effective_tension", $c1110], ["power", $c1111], ["run", $c1112], ["share", $c1113], ["speeds", $c1114]]);
const $c1105 = $made(Table, {of: null, entries: $c1106, _known: $c1107});
const $c1104 = $made(Entry, {key: "train", kind: $c1105, required: false, alias: "", example: "", attribute: "train", unless: ""});
const $c1102 = [$c984, $c985, $c986, $c987, $c988, $c1104];
const $c1103 = new Map([["name", $c984], ["description", $c985], ["kind", $c986], ["condition", $c987], ["pulley", $c988], ["train", $c1104]]);
const $c1101 = $made(Table, {of: null, entries: $c1102, _known: $c1103});
const $c1100 = $made(Rows, {kind: $c1101, least: 1, most: 1000});
const $c1098 = $made(Entry, {key: "load_case", kind: $c1100, required: false, alias: "", example: "", attribute: "load_case", unless: ""});
const $c1129 = $made(Quantity, {dimension: "length", limit: $c666});
const $c1128 = $made(Rows, {kind: $c1129, least: 1, most: 10});
const $c1126 = $made(Entry, {key: "diameters", kind: $c1128, required: false, alias: "", example: "", attribute: "diameters", unless: ""});
const $c1145 = ["converter"];
const $c1144 = $made(Choice, {options: $c1145});
const $c1133 = $made(Entry, {key: "kind", kind: $c1144, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c1147 = $made(Limit, {dimension: "power", least: 0.0, most: 1000000000.0, open: true, rigid: false});
const $c1146 = $made(Quantity, {dimension: "power", limit: $c1147});
const $c1134 = $made(Entry, {key: "rated_power", kind: $c1146, required: true, alias: "", example: "", attribute: "rated_power", unless: ""});
const $c1149 = $made(Limit, {dimension: "rotation_speed", least: 0.0, most: 100000.0, open: true, rigid: false});
const $c1148 = $made(Quantity, {dimension: "rotation_speed", limit: $c1149});
const $c1135 = $made(Entry, {key: "rated_speed", kind: $c1148, required: true, alias: "", example: "", attribute: "rated_speed", unless: ""});
const $c1151 = $made(Limit, {dimension: "number", least: 0.0, most: 10000.0, open: true, rigid: false});
const $c1150 = $made(Quantity, {dimension: "number", limit: $c1151});
const $c1136 = $made(Entry, {key: "gear_ratio", kind: $c1150, required: false, alias: "", example: "", attribute: "gear_ratio", unless: ""});
const $c1153 = $made(Limit, {dimension: "number", least: 0.05, most: 1.0, open: false, rigid: false});
const $c1152 = $made(Quantity, {dimension: "number", limit: $c1153});
const $c1137 = $made(Entry, {key: "gear_efficiency", kind: $c1152, required: false, alias: "", example: "", attribute: "gear_efficiency", unless: ""});
const $c1155 = $made(Limit, {dimension: "number", least: 0.05, most: 1.0, open: false, rigid: false});
const $c1154 = $made(Quantity, {dimension: "number", limit: $c1155});
const $c1138 = $made(Entry, {key: "motor_efficiency", kind: $c1154, required: false, alias: "", example: "", attribute: "motor_efficiency", unless: ""});
const $c1156 = $made(Count, {least: 1, most: 8});
const $c1139 = $made(Entry, {key: "count", kind: $c1156, required: false, alias: "", example: "", attribute: "count", unless: ""});
const $c1157 = $made(Flag, {});
const $c1140 = $made(Entry, {key: "brakes", kind: $c1157, required: false, alias: "", example: "", attribute: "brakes", unless: ""});
const $c1159 = $made(Limit, {dimension: "number", least: 0.01, most: 3.0, open: false, rigid: false});
const $c1158 = $made(Quantity, {dimension: "number", limit: $c1159});
const $c1141 = $made(Entry, {key: "setting", kind: $c1158, required: false, alias: "", example: "", attribute: "setting", unless: ""});
const $c1161 = $made(Limit, {dimension: "number", least: 0.0, most: 0.5, open: false, rigid: false});
const $c1160 = $made(Quantity, {dimension: "number", limit: $c1161});
const $c1142 = $made(Entry, {key: "droop", kind: $c1160, required: false, alias: "", example: "", attribute: "droop", unless: ""});
const $c1164 = $made(Limit, {dimension: "number", least: 0.0, most: Infinity, open: true, rigid: true});
const $c1163 = $made(Quantity, {dimension: "number", limit: $c1164});
const $c1162 = $made(WordOr, {word: "rigid", kind: $c1163, meaning: Infinity});
const $c1143 = $made(Entry, {key: "torque_limit", kind: $c1162, required: false, alias: "", example: "", attribute: "torque_limit", unless: ""});
const $c1131 = [$c1133, $c1134, $c1135, $c1136, $c1137, $c1138, $c1139, $c1140, $c1141, $c1142, $c1143];
const $c1132 = new Map([["kind", $c1133], ["rated_power", $c1134], ["rated_speed", $c1135], ["gear_ratio", $c1136], ["gear_efficiency", $c1137], ["motor_efficiency", $c1138], ["count", $c1139], ["brakes", $c1140], ["setting", $c1141], ["droop", $c1142], ["torque_limit", $c1143]]);
const $c571 = $made(Table, {of: VariableSpeed, entries: $c1131, _known: $c1132});
const $c1177 = ["induction"];
const $c1176 = $made(Choice, {options: $c1177});
const $c1167 = $made(Entry, {key: "kind", kind: $c1176, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c1178 = $made(Quantity, {dimension: "power", limit: $c1147});
const $c1168 = $made(Entry, {key: "rated_power", kind: $c1178, required: true, alias: "", example: "", attribute: "rated_power", unless: ""});
const $c1179 = $made(Quantity, {dimension: "rotation_speed", limit: $c1149});
const $c1169 = $made(Entry, {key: "rated_speed", kind: $c1179, required: true, alias: "", example: "", attribute: "rated_speed", unless: ""});
const $c1180 = $made(Quantity, {dimension: "number", limit: $c1151});
const $c1170 = $made(Entry, {key: "gear_ratio", kind: $c1180, required: false, alias: "", example: "", attribute: "gear_ratio", unless: ""});
const $c1181 = $made(Quantity, {dimension: "number", limit: $c1153});
const $c1171 = $made(Entry, {key: "gear_efficiency", kind: $c1181, required: false, alias: "", example: "", attribute: "gear_efficiency", unless: ""});
const $c1182 = $made(Quantity, {dimension: "number", limit: $c1155});
const $c1172 = $made(Entry, {key: "motor_efficiency", kind: $c1182, required: false, alias: "", example: "", attribute: "motor_efficiency", unless: ""});
const $c1183 = $made(Flag, {});
const $c1173 = $made(Entry, {key: "brakes", kind: $c1183, required: false, alias: "", example: "", attribute: "brakes", unless: ""});
const $c1185 = $made(Limit, {dimension: "rotation_speed", least: 0.0, most: 100000.0, open: true, rigid: false});
const $c1184 = $made(Quantity, {dimension: "rotation_speed", limit: $c1185});
const $c1174 = $made(Entry, {key: "synchronous_speed", kind: $c1184, required: true, alias: "", example: "", attribute: "synchronous_speed", unless: ""});
const $c1187 = $made(Limit, {dimension: "number", least: 1.1, most: 10.0, open: false, rigid: false});
const $c1186 = $made(Quantity, {dimension: "number", limit: $c1187});
const $c1175 = $made(Entry, {key: "breakdown_ratio", kind: $c1186, required: false, alias: "", example: "", attribute: "breakdown_ratio", unless: ""});
const $c1165 = [$c1167, $c1168, $c1169, $c1170, $c1171, $c1172, $c1139, $c1173, $c1174, $c1175];
const $c1166 = new Map([["kind", $c1167], ["rated_power", $c1168], ["rated_speed", $c1169], ["gear_ratio", $c1170], ["gear_efficiency", $c1171], ["motor_efficiency", $c1172], ["count", $c1139], ["brakes", $c1173], ["synchronous_speed", $c1174], ["breakdown_ratio", $c1175]]);
const $c572 = $made(Table, {of: Induction, entries: $c1165, _known: $c1166});
const $c1202 = ["fluid-coupling"];
const $c1201 = $made(Choice, {options: $c1202});
const $c1190 = $made(Entry, {key: "kind", kind: $c1201, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c1203 = $made(Quantity, {dimension: "power", limit: $c1147});
const $c1191 = $made(Entry, {key: "rated_power", kind: $c1203, required: true, alias: "", example: "", attribute: "rated_power", unless: ""});
const $c1204 = $made(Quantity, {dimension: "rotation_speed", limit: $c1149});
const $c1192 = $made(Entry, {key: "rated_speed", kind: $c1204, required: true, alias: "", example: "", attribute: "rated_speed", unless: ""});
const $c1205 = $made(Quantity, {dimension: "number", limit: $c1151});
const $c1193 = $made(Entry, {key: "gear_ratio", kind: $c1205, required: false, alias: "", example: "", attribute: "gear_ratio", unless: ""});
const $c1206 = $made(Quantity, {dimension: "number", limit: $c1153});
const $c1194 = $made(Entry, {key: "gear_efficiency", kind: $c1206, required: false, alias: "", example: "", attribute: "gear_efficiency", unless: ""});
const $c1207 = $made(Quantity, {dimension: "number", limit: $c1155});
const $c1195 = $made(Entry, {key: "motor_efficiency", kind: $c1207, required: false, alias: "", example: "", attribute: "motor_efficiency", unless: ""});
const $c1208 = $made(Flag, {});
const $c1196 = $made(Entry, {key: "brakes", kind: $c1208, required: false, alias: "", example: "", attribute: "brakes", unless: ""});
const $c1209 = $made(Quantity, {dimension: "rotation_speed", limit: $c1185});
const $c1197 = $made(Entry, {key: "synchronous_speed", kind: $c1209, required: true, alias: "", example: "", attribute: "synchronous_speed", unless: ""});
const $c1210 = $made(Quantity, {dimension: "number", limit: $c1187});
const $c1198 = $made(Entry, {key: "breakdown_ratio", kind: $c1210, required: false, alias: "", example: "", attribute: "breakdown_ratio", unless: ""});
const $c1213 = $made(Limit, {dimension: "number", least: 0.0, most: 10.0, open: false, rigid: false});
const $c1212 = $made(Quantity, {dimension: "number", limit: $c1213});
const $c1211 = $made(Rows, {kind: $c1212, least: 2, most: 200});
const $c1199 = $made(Entry, {key: "coupling_load", kind: $c1211, required: true, alias: "", example: "", attribute: "coupling_load", unless: ""});
const $c1200 = $made(Entry, {key: "coupling_slip", kind: $c1211, required: true, alias: "", example: "", attribute: "coupling_slip", unless: ""});
const $c1188 = [$c1190, $c1191, $c1192, $c1193, $c1194, $c1195, $c1139, $c1196, $c1197, $c1198, $c1199, $c1200];
const $c1189 = new Map([["kind", $c1190], ["rated_power", $c1191], ["rated_speed", $c1192], ["gear_ratio", $c1193], ["gear_efficiency", $c1194], ["motor_efficiency", $c1195], ["count", $c1139], ["brakes", $c1196], ["synchronous_speed", $c1197], ["breakdown_ratio", $c1198], ["coupling_load", $c1199], ["coupling_slip", $c1200]]);
const $c573 = $made(Table, {of: FluidCoupling, entries: $c1188, _known: $c1189});
const $c1220 = ["follower"];
const $c1219 = $made(Choice, {options: $c1220});
const $c1216 = $made(Entry, {key: "kind", kind: $c1219, required: true, alias: "", example: "", attribute: "kind", unless: ""});
const $c1221 = $made(Name, {longest: 60});
const $c1217 = $made(Entry, {key: "master", kind: $c1221, required: true, alias: "", example: "", attribute: "master", unless: ""});
const $c592 = $made(Limit, {dimension: "number", least: -10.0, most: 10.0, open: false, rigid: false});
const $c1222 = $made(Quantity, {dimension: "number", limit: $c592});
const $c1218 = $made(Entry, {key: "ratio", kind: $c1222, required: false, alias: "", example: "", attribute: "ratio", unless: ""});
const $c1214 = [$c1216, $c1217, $c1218];
const $c1215 = new Map([["kind", $c1216], ["master", $c1217], ["ratio", $c1218]]);
const $c574 = $made(Table, {of: TorqueFollower, entries: $c1214, _known: $c1215});
const $c64 = new Map([["converter", $c571], ["induction", $c572], ["fluid-coupling", $c573], ["follower", $c574]]);
const $c65 = $made(Variant, {tag: "kind", tables: $c64});
const $c1130 = $made(ByName, {kind: $c65, most: 200});
const $c1127 = $made(Entry, {key: "motor", kind: $c1130, required: false, alias: "", example: "", attribute: "motor", unless: ""});
const $c1124 = [$c1108, $c1109, $c1110, $c1111, $c1112, $c1113, $c1114, $c1126, $c1127];
const $c1125 = new Map([["entry_tension", $c1108], ["exit_tension", $c1109], ["effective_tension", $c1110], ["power", $c1111], ["run", $c1112], ["share", $c1113], ["speeds", $c1114], ["diameters", $c1126], ["motor", $c1127]]);
const $c1123 = $made(Table, {of: null, entries: $c1124, _known: $c1125});
const $c1099 = $made(Entry, {key: "train", kind: $c1123, required: false, alias: "", example: "", attribute: "train", unless: ""});
const $c1096 = [$c622, $c623, $c624, $c625, $c626, $c627, $c628, $c629, $c1098, $c631, $c495, $c496, $c497, $c498, $c1099, $c633];
const $c1097 = new Map([["format", $c622], ["title", $c623], ["description", $c624], ["creep_limit", $c625], ["condition", $c626], ["belt", $c627], ["pulley", $c628], ["lagging", $c629], ["load_case", $c1098], ["conveyor", $c631], ["take_up", $c495], ["design_standard", $c496], ["safety_factor", $c497], ["sag", $c498], ["train", $c1099], ["motion", $c633]]);
const $c40 = $made(Table, {of: Drive, entries: $c1096, _known: $c1097});
const $c41 = $re("[A-Za-z0-9_-]{1,60}", "");
const $c42 = $re("\\.?([A-Za-z_][A-Za-z0-9_]*)|\\[(\\d+)\\]", "");
const $c43 = ["format", "name", "title", "description", "surface", "thickness", "elastic_modulus", "shear_modulus", "compression_modulus", "block", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "slip_speed", "temperature", "condition_factor", "law", "provenance", "sources", "notes"];
const $c44 = ["name", "title", "description", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit"];
const $c46 = ["elastic_modulus", "shear_modulus", "compression_modulus", "block"];
const $c47 = ["thickness", "shear_modulus", "compression_modulus"];
const $c50 = new Map([["friction_coefficient", "friction"], ["slip_max", "tested_slip"], ["tested", "tested_pressure"], ["pieces.a", "A"], ["values", "rows"], ["peak_friction", "knots"], ["peak_slip", "knots"], ["post_peak_slope", "knots"], ["residual_friction", "knots"]]);
const $c51 = new Map([["integral-log", "knots"], ["table", "rows"]]);
const $c53 = $re("\\s*(?<sign>[+-])?\\s*(?<number>(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)?\\s*\\*?\\s*(?<factor>p(?:\\s*\\^\\s*(?:\\(\\s*(?<within>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\\s*\\)|(?<power>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)))?|ln\\(\\s*p\\s*\\)(?:\\s*\\^\\s*(?<log_power>[123]))?|exp\\((?<exponent>(?:[^()]|\\(\\s*p\\s*\\))*)\\))?\\s*", "");
const $c1234 = $made(Name, {longest: 60});
const $c1225 = $made(Entry, {key: "name", kind: $c1234, required: true, alias: "", example: "name = \"my-lagging\"", attribute: "name", unless: ""});
const $c1235 = $made(Quantity, {dimension: "length", limit: $c584});
const $c1226 = $made(Entry, {key: "thickness", kind: $c1235, required: false, alias: "", example: "", attribute: "thickness", unless: ""});
const $c1236 = $made(Quantity, {dimension: "pressure", limit: $c587});
const $c1227 = $made(Entry, {key: "elastic_modulus", kind: $c1236, required: false, alias: "", example: "", attribute: "elastic_modulus", unless: ""});
const $c1238 = $made(Quantity, {dimension: "pressure", limit: $c585});
const $c1237 = $made(WordOr, {word: "rigid", kind: $c1238, meaning: Infinity});
const $c1228 = $made(Entry, {key: "shear_modulus", kind: $c1237, required: false, alias: "", example: "", attribute: "shear_modulus", unless: ""});
const $c1240 = $made(Quantity, {dimension: "pressure", limit: $c586});
const $c1239 = $made(WordOr, {word: "rigid", kind: $c1240, meaning: Infinity});
const $c1229 = $made(Entry, {key: "compression_modulus", kind: $c1239, required: false, alias: "", example: "", attribute: "compression_modulus", unless: ""});
const $c1241 = $made(Quantity, {dimension: "wear_coefficient", limit: $c588});
const $c1230 = $made(Entry, {key: "wear_coefficient", kind: $c1241, required: false, alias: "", example: "", attribute: "wear_coefficient", unless: ""});
const $c1242 = $made(Quantity, {dimension: "number", limit: $c589});
const $c1231 = $made(Entry, {key: "belt_energy_share", kind: $c1242, required: false, alias: "", example: "", attribute: "belt_energy_share", unless: ""});
const $c1243 = $made(Quantity, {dimension: "pressure", limit: $c590});
const $c1232 = $made(Entry, {key: "bond_strength", kind: $c1243, required: false, alias: "", example: "", attribute: "bond_strength", unless: ""});
const $c1244 = $made(Quantity, {dimension: "pressure", limit: $c591});
const $c1233 = $made(Entry, {key: "fatigue_limit", kind: $c1244, required: false, alias: "", example: "", attribute: "fatigue_limit", unless: ""});
const $c1223 = [$c622, $c1225, $c694, $c695, $c696, $c1226, $c1227, $c1228, $c1229, $c701, $c1230, $c1231, $c1232, $c1233, $c706, $c707, $c708, $c709, $c710, $c98, $c99, $c711];
const $c1224 = new Map([["format", $c622], ["name", $c1225], ["title", $c694], ["description", $c695], ["surface", $c696], ["thickness", $c1226], ["elastic_modulus", $c1227], ["shear_modulus", $c1228], ["compression_modulus", $c1229], ["block", $c701], ["wear_coefficient", $c1230], ["belt_energy_share", $c1231], ["bond_strength", $c1232], ["fatigue_limit", $c1233], ["cost", $c706], ["slip_speed", $c707], ["temperature", $c708], ["condition_factor", $c709], ["law", $c710], ["provenance", $c98], ["sources", $c99], ["notes", $c711]]);
const $c57 = $made(Table, {of: Lagging, entries: $c1223, _known: $c1224});
const $c507 = ["compression_modulus", "block"];
const $c58 = [$c507];
const $c59 = new Set(["belt_energy_share", "block", "bond_strength", "compression_modulus", "condition_factor", "cost", "elastic_modulus", "fatigue_limit", "law", "shear_modulus", "slip_speed", "temperature", "thickness", "wear_coefficient"]);
const $c529 = [0.25, 0.25];
const $c530 = $made(Provenance, {kind: "published", source: "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", date: "", note: ""});
const $c508 = $made(DesignFriction, {standard: "CEMA", surface: "bare", condition: "", friction: $c529, provenance: $c530});
const $c531 = [0.35, 0.35];
const $c532 = $made(Provenance, {kind: "published", source: "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", date: "", note: ""});
const $c509 = $made(DesignFriction, {standard: "CEMA", surface: "rubber", condition: "", friction: $c531, provenance: $c532});
const $c533 = [0.5, 0.5];
const $c534 = $made(Provenance, {kind: "published", source: "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", date: "", note: "dimpled ceramic"});
const $c510 = $made(DesignFriction, {standard: "CEMA", surface: "ceramic", condition: "", friction: $c533, provenance: $c534});
const $c535 = [0.35, 0.4];
const $c536 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: ""});
const $c511 = $made(DesignFriction, {standard: "DIN 22101", surface: "bare", condition: "dry", friction: $c535, provenance: $c536});
const $c537 = [0.1, 0.1];
const $c538 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "single value, partly from IS 11592 and REMA"});
const $c512 = $made(DesignFriction, {standard: "DIN 22101", surface: "bare", condition: "wet", friction: $c537, provenance: $c538});
const $c539 = [0.05, 0.1];
const $c540 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: ""});
const $c513 = $made(DesignFriction, {standard: "DIN 22101", surface: "bare", condition: "wet and dirty", friction: $c539, provenance: $c540});
const $c541 = [0.4, 0.45];
const $c542 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "herringbone grooves"});
const $c514 = $made(DesignFriction, {standard: "DIN 22101", surface: "rubber", condition: "dry", friction: $c541, provenance: $c542});
const $c543 = [0.35, 0.35];
const $c544 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "herringbone grooves; single value, partly from IS 11592 and REMA"});
const $c515 = $made(DesignFriction, {standard: "DIN 22101", surface: "rubber", condition: "wet", friction: $c543, provenance: $c544});
const $c545 = [0.25, 0.3];
const $c546 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "herringbone grooves"});
const $c516 = $made(DesignFriction, {standard: "DIN 22101", surface: "rubber", condition: "wet and dirty", friction: $c545, provenance: $c546});
const $c547 = [0.35, 0.4];
const $c548 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: ""});
const $c517 = $made(DesignFriction, {standard: "DIN 22101", surface: "polyurethane", condition: "dry", friction: $c547, provenance: $c548});
const $c549 = [0.35, 0.35];
const $c550 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "single value, partly from IS 11592 and REMA"});
const $c518 = $made(DesignFriction, {standard: "DIN 22101", surface: "polyurethane", condition: "wet", friction: $c549, provenance: $c550});
const $c551 = [0.2, 0.2];
const $c552 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "single value, partly from IS 11592 and REMA"});
const $c519 = $made(DesignFriction, {standard: "DIN 22101", surface: "polyurethane", condition: "wet and dirty", friction: $c551, provenance: $c552});
const $c553 = [0.4, 0.45];
const $c554 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: ""});
const $c520 = $made(DesignFriction, {standard: "DIN 22101", surface: "ceramic", condition: "dry", friction: $c553, provenance: $c554});
const $c555 = [0.35, 0.4];
const $c556 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: ""});
const $c521 = $made(DesignFriction, {standard: "DIN 22101", surface: "ceramic", condition: "wet", friction: $c555, provenance: $c556});
const $c557 = [0.35, 0.35];
const $c558 = $made(Provenance, {kind: "published", source: "DIN 22101 by works that follow it (they do not tell the edition; that of the resistances here is 2002-08)", date: "", note: "single value, partly from IS 11592 and REMA"});
const $c522 = $made(DesignFriction, {standard: "DIN 22101", surface: "ceramic", condition: "wet and dirty", friction: $c557, provenance: $c558});
const $c559 = [0.35, 0.35];
const $c560 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "diamond rubber"});
const $c523 = $made(DesignFriction, {standard: "practice", surface: "rubber", condition: "dry", friction: $c559, provenance: $c560});
const $c561 = [0.35, 0.35];
const $c562 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "diamond rubber"});
const $c524 = $made(DesignFriction, {standard: "practice", surface: "rubber", condition: "wet", friction: $c561, provenance: $c562});
const $c563 = [0.3, 0.3];
const $c564 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "diamond rubber"});
const $c525 = $made(DesignFriction, {standard: "practice", surface: "rubber", condition: "wet and dirty", friction: $c563, provenance: $c564});
const $c565 = [0.8, 0.8];
const $c566 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "ceramic in rubber"});
const $c526 = $made(DesignFriction, {standard: "practice", surface: "ceramic", condition: "dry", friction: $c565, provenance: $c566});
const $c567 = [0.45, 0.45];
const $c568 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "ceramic in rubber"});
const $c527 = $made(DesignFriction, {standard: "practice", surface: "ceramic", condition: "wet", friction: $c567, provenance: $c568});
const $c569 = [0.35, 0.35];
const $c570 = $made(Provenance, {kind: "published", source: "Practitioners' values for a running drive, bulk-online forum", date: "2005", note: "ceramic in rubber"});
const $c528 = $made(DesignFriction, {standard: "practice", surface: "ceramic", condition: "wet and dirty", friction: $c569, provenance: $c570});
const $c60 = [$c508, $c509, $c510, $c511, $c512, $c513, $c514, $c515, $c516, $c517, $c518, $c519, $c520, $c521, $c522, $c523, $c524, $c525, $c526, $c527, $c528];
const $c61 = new RunsGain(0.0, 0.0);
const $c63 = ["share", "speeds", "motor"];
const $c66 = $Decimal.of("0");
const $c575 = [0.0];
const $c67 = $made(Trend, {form: "polynomial", coefficients: $c575, sign: 1});
const $c576 = [1000000000.0];
const $c68 = $made(Trend, {form: "polynomial", coefficients: $c576, sign: 1});
const $c69 = new Map([["factor", $c577]]);
const $c70 = new Map([["x", $c578], ["y", $c578], ["diameter", $c579]]);
const $c581 = $made(Limit, {dimension: "force", least: 0.1, most: 1000000000.0, open: false, rigid: false});
const $c71 = new Map([["entry", $c580], ["exit", $c581]]);
const $c72 = new Map([["creep_limit", $c582]]);
const $c583 = $made(Limit, {dimension: "length", least: 0.0, most: Infinity, open: true, rigid: false});
const $c73 = new Map([["creep_limit", $c583]]);
const $c74 = new Map([["thickness", $c584], ["shear_modulus", $c585], ["compression_modulus", $c586], ["elastic_modulus", $c587], ["wear_coefficient", $c588], ["belt_energy_share", $c589], ["bond_strength", $c590], ["fatigue_limit", $c591]]);
const $c75 = new Map([["ratio", $c592]]);
const $c76 = new Map([["entry_tension", $c580], ["exit_tension", $c581]]);
const $c77 = new Map([["sheave_ratio", $c593]]);
const $c78 = new Map([["friction", $c594], ["start_factor", $c595]]);
const $c79 = new Map([["running", $c595], ["starting", $c595], ["braking", $c595]]);
const $c1245 = [false, false];
const $c1246 = [true, false];
const $c1247 = [true, true];
const $c1248 = [false, true];
const $c596 = new Map([["polynomial", $c1245], ["logarithmic", $c1246], ["power", $c1247], ["exponential", $c1248]]);
const $c601 = $made(_OfClass, {});
const $c602 = new Map([[10, null], [9, null]]);
const $c1249 = [80.0, 1.92];
const $c1250 = [90.0, 1.86];
const $c1251 = [100.0, 1.78];
const $c1252 = [120.0, 1.7];
const $c1253 = [140.0, 1.63];
const $c1254 = [160.0, 1.56];
const $c1255 = [180.0, 1.5];
const $c1256 = [200.0, 1.45];
const $c1257 = [250.0, 1.38];
const $c1258 = [300.0, 1.31];
const $c1259 = [350.0, 1.27];
const $c1260 = [400.0, 1.25];
const $c1261 = [450.0, 1.22];
const $c1262 = [500.0, 1.2];
const $c1263 = [550.0, 1.18];
const $c1264 = [600.0, 1.17];
const $c1265 = [700.0, 1.14];
const $c1266 = [800.0, 1.12];
const $c1267 = [900.0, 1.1];
const $c1268 = [1000.0, 1.09];
const $c1269 = [1500.0, 1.06];
const $c1270 = [2000.0, 1.05];
const $c605 = [$c1249, $c1250, $c1251, $c1252, $c1253, $c1254, $c1255, $c1256, $c1257, $c1258, $c1259, $c1260, $c1261, $c1262, $c1263, $c1264, $c1265, $c1266, $c1267, $c1268, $c1269, $c1270];
const $c1271 = $made(Limit, {dimension: "number", least: 0.0, most: Infinity, open: false, rigid: false});
const $c1272 = $made(Limit, {dimension: "number", least: 1.0, most: Infinity, open: false, rigid: false});
const $c607 = new Map([["residual_noise", $c1271], ["coverage_factor", $c1272]]);
const $c608 = $Decimal.of("0");
const $c609 = new Map([["misalignment", $c937], ["deflection", $c939]]);
const $c610 = new Map([["diameter", $c666], ["wrap_angle", $c667], ["overrun", $c919], ["creep_limit", $c920], ["mass", $c921]]);
const $c611 = new Map([["spacing", $c1089], ["line_mass", $c1091], ["share", $c1093]]);
const $c1273 = $made(Limit, {dimension: "speed", least: 0.0, most: Infinity, open: true, rigid: false});
const $c1274 = $made(Limit, {dimension: "number", least: 0.01, most: 100.0, open: false, rigid: false});
const $c612 = new Map([["length", $c1020], ["lift", $c1022], ["belt_mass", $c1024], ["carry_idler_mass", $c1026], ["return_idler_mass", $c1028], ["material_mass", $c1024], ["capacity", $c1031], ["friction_factor", $c1033], ["length_coefficient", $c1035], ["secondary_resistance", $c1037], ["special_resistance", $c1037], ["return_share", $c1040], ["start_factor", $c1042], ["start_time", $c1044], ["stop_time", $c1044], ["take_up_tension", $c1047], ["counterweight", $c1049], ["take_up_distance", $c1051], ["speed", $c1273], ["sheave_ratio", $c1274]]);
const $c613 = new Map([["material", $c751], ["installation", $c753], ["area", $c756]]);
const $c614 = new Map([["width", $c732], ["height", $c734], ["stiffening", $c736], ["contact_fraction", $c738]]);
const $c1275 = $made(Limit, {dimension: "number", least: 0.0, most: 10.0, open: true, rigid: false});
const $c615 = new Map([["factor", $c1275]]);
const $c1276 = $made(Limit, {dimension: "number", least: 1, most: 8, open: false, rigid: false});
const $c616 = new Map([["rated_power", $c1147], ["rated_speed", $c1149], ["gear_ratio", $c1151], ["gear_efficiency", $c1153], ["motor_efficiency", $c1155], ["count", $c1276]]);
const $c617 = new Map([["rated_power", $c1147], ["rated_speed", $c1149], ["gear_ratio", $c1151], ["gear_efficiency", $c1153], ["motor_efficiency", $c1155], ["count", $c1276], ["setting", $c1159], ["droop", $c1161], ["torque_limit", $c1164]]);
const $c618 = new Map([["rated_power", $c1147], ["rated_speed", $c1149], ["gear_ratio", $c1151], ["gear_efficiency", $c1153], ["motor_efficiency", $c1155], ["count", $c1276], ["synchronous_speed", $c1185], ["breakdown_ratio", $c1187]]);
const $c619 = new Map([["length", $c963], ["trough_angle", $c965], ["centre_roll", $c967]]);
const $c1277 = [0.016, 0.03];
const $c1278 = new Map([["distance", $c952]]);
const $c1353 = $made(Limit, {dimension: "number", least: 0.0, most: 10.0, open: true, rigid: false});
const $c1351 = $made(Quantity, {dimension: "number", limit: $c1353});
const $c1354 = $made(Limit, {dimension: "rotation_speed", least: 0.0, most: Infinity, open: true, rigid: false});
const $c1352 = $made(Quantity, {dimension: "rotation_speed", limit: $c1354});
const $c1350 = $made(Either, {first: $c1351, second: $c1352, words: "a trim like \"99.7 %\" or a drum speed like \"71.6 rpm\""});
const $c1279 = $made(Rows, {kind: $c1350, least: 1, most: 10});
$sig(Problem, ["message", "remedy", "file", "key", "value", "line", "code"]);
Problem.$compared = ["message", "remedy", "file", "key", "value", "line", "code"];
$sig(InputError, ["problems"], false);
$sig(Report, ["file"], false);
$sig(Report.prototype.add, ["place", "message", "remedy", "value", "code"], false);
$sig(Record, ["values", "place", "raw", "faulty"], false);
$sig(Provenance, ["kind", "source", "date", "note"]);
Provenance.$compared = ["kind", "source", "date", "note"];
$sig(Laggings, ["own", "folder", "allow_paths", "report"], false);
$sig(Condition, ["name", "factor", "factors", "standard", "source"]);
Condition.$compared = ["name", "factor", "factors", "standard", "source"];
Condition.LIMITS = Condition.prototype.LIMITS = $c69;
$sig(Conditions, ["main", "cases"]);
Conditions.$compared = ["main", "cases"];
$sig(Point, ["x", "y", "diameter", "turn"]);
Point.$compared = ["x", "y", "diameter", "turn"];
Point.LIMITS = Point.prototype.LIMITS = $c70;
$sig(_UnitTextError, ["message", "remedy"], false);
$sig(Unit, ["factor", "powers", "zero"]);
Unit.$compared = ["factor", "powers", "zero"];
$sig(UnitRow, ["unit", "factor", "larger"]);
UnitRow.$compared = ["unit", "factor", "larger"];
$sig(WidthProfile, ["position", "value", "crown", "uncertainty"]);
WidthProfile.$compared = ["position", "value", "crown", "uncertainty"];
$sig(Criteria, ["take_up", "standard", "safety", "sag"]);
Criteria.$compared = ["take_up", "standard", "safety", "sag"];
$sig(Layers, ["pulley_cover", "carry_cover", "carcass"]);
Layers.$compared = ["pulley_cover", "carry_cover", "carcass"];
$sig(Given, ["name", "place", "values", "raw", "diameter", "inherited"]);
Given.$compared = ["name", "place", "values", "raw", "diameter", "inherited"];
$sig(Given.prototype.overridden, ["record", "fixed", "speed", "runs"], false);
$sig(NipTensions, ["entry", "exit"]);
NipTensions.$compared = ["entry", "exit"];
$sig(LoadFault, ["message", "remedy", "lacks"]);
LoadFault.$compared = ["message", "remedy", "lacks"];
$sig(Tensions, ["entry", "exit", "computed"]);
Tensions.$compared = ["entry", "exit"];
Tensions.LIMITS = Tensions.prototype.LIMITS = $c71;
$sig(LoadCase, ["name", "tensions", "kind", "condition"]);
LoadCase.$compared = ["name", "tensions", "kind", "condition"];
$sig(Drive, ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description", "conveyor"]);
Drive.$compared = ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description"];
Drive.LIMITS = Drive.prototype.LIMITS = $c72;
$sig(Train, ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria"]);
Train.$compared = ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria"];
Train.LIMITS = Train.prototype.LIMITS = $c73;
$sig(Reader, ["record", "belt", "pulleys", "report", "take_up"], false);
$sig(CatalogueBelt, ["name", "kind", "rating", "modulus", "least_pulley_diameter", "carcass", "carcass_mass", "cover_mass", "provenance", "carcass_source"]);
CatalogueBelt.$compared = ["name", "kind", "rating", "modulus", "least_pulley_diameter", "carcass", "carcass_mass", "cover_mass", "provenance", "carcass_source"];
$sig(TestedRange, ["pressure_min", "pressure_max", "slip_max", "slip_speed"]);
TestedRange.$compared = ["pressure_min", "pressure_max", "slip_max", "slip_speed"];
$sig(FrictionLaw, ["slip_includes"]);
FrictionLaw.$compared = ["slip_includes"];
$sig(MeasuredTable, ["slip_includes", "slip", "pressure", "values"]);
MeasuredTable.$compared = ["slip_includes", "slip", "pressure", "values"];
MeasuredTable.title = MeasuredTable.prototype.title = "measured table";
$sig(_Term, ["coefficient", "function", "power", "exponent"]);
_Term.$compared = ["coefficient", "function", "power", "exponent"];
$sig(Trend, ["form", "coefficients", "sign"]);
Trend.$compared = ["form", "coefficients", "sign"];
$sig(Piece, ["a", "b", "post_peak_slope", "residual_friction"]);
Piece.$compared = ["a", "b", "post_peak_slope", "residual_friction"];
$sig(CoefficientPieces, ["pressure", "pieces", "slip_unit", "continuity"]);
CoefficientPieces.$compared = ["pressure", "pieces", "slip_unit", "continuity"];
$sig(PressureKnots, ["pressure", "peak_friction", "peak_slip", "post_peak_slope", "residual_friction"]);
PressureKnots.$compared = ["pressure", "peak_friction", "peak_slip", "post_peak_slope", "residual_friction"];
$sig(IntegralLog, ["slip_includes", "coefficients", "tested"]);
IntegralLog.$compared = ["slip_includes", "coefficients", "tested"];
IntegralLog.title = IntegralLog.prototype.title = "integral-log law";
$sig(Factors, ["law", "by_slip_speed", "by_temperature", "slip_speed", "temperature"]);
Factors.$compared = ["law", "by_slip_speed", "by_temperature", "slip_speed", "temperature"];
$sig(Lagging, ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "block", "provenance", "sources", "notes", "description"]);
Lagging.$compared = ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "provenance", "sources", "notes", "description"];
Lagging.LIMITS = Lagging.prototype.LIMITS = $c74;
$sig(LoadGiven, ["entry_tension", "exit_tension", "effective_tension", "torque", "power"]);
LoadGiven.$compared = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
$sig(DrumAt, ["diameter", "speed"]);
DrumAt.$compared = ["diameter", "speed"];
$sig(Shares, ["fractions"]);
Shares.$compared = ["fractions"];
$sig(Pair, ["entry", "exit"]);
Pair.$compared = ["entry", "exit"];
$sig(Pulls, ["effective_tensions"]);
Pulls.$compared = ["effective_tensions"];
$sig(Speeds, ["rotation_speeds", "absolute"]);
Speeds.$compared = ["rotation_speeds", "absolute"];
$sig(TorqueFollower, ["master", "ratio"]);
TorqueFollower.$compared = ["master", "ratio"];
TorqueFollower.LIMITS = TorqueFollower.prototype.LIMITS = $c75;
$sig(TrainCase, ["name", "entry_tension", "exit_tension", "division", "runs", "kind", "condition"]);
TrainCase.$compared = ["name", "entry_tension", "exit_tension", "division", "runs", "kind", "condition"];
TrainCase.LIMITS = TrainCase.prototype.LIMITS = $c76;
$sig(RunsGain, ["base", "case"]);
RunsGain.$compared = ["base", "case"];
$sig(BehindTakeUp, ["share", "behind", "runs"]);
BehindTakeUp.$compared = ["share", "behind", "runs"];
$sig(Motors, ["motors"]);
Motors.$compared = ["motors"];
$sig(TakeUp, ["kind", "sheave_ratio", "after"]);
TakeUp.$compared = ["kind", "sheave_ratio", "after"];
TakeUp.LIMITS = TakeUp.prototype.LIMITS = $c77;
$sig(DesignStandard, ["name", "condition", "friction", "start_factor", "binding"]);
DesignStandard.$compared = ["name", "condition", "friction", "start_factor", "binding"];
DesignStandard.LIMITS = DesignStandard.prototype.LIMITS = $c78;
$sig(SafetyFactors, ["running", "starting", "braking", "source"]);
SafetyFactors.$compared = ["running", "starting", "braking", "source"];
SafetyFactors.LIMITS = SafetyFactors.prototype.LIMITS = $c79;
$sig(Kind.prototype.built, ["value", "report"], true);
$sig(Table, ["title", "of", "on_one_line"], false);
$sig(Table.prototype.built, ["value", "report"], true);
$sig(Entry, ["key", "meaning", "kind", "title", "required", "alias", "example", "attribute", "unless", "stated"]);
$sig(Name, ["longest"]);
$sig(Text, ["longest", "lines"]);
$sig(Quantity, ["dimension", "limit"]);
$sig(WordOr, ["word", "kind", "meaning"]);
$sig(ByName, ["kind", "most"]);
$sig(Limit, ["dimension", "least", "most", "open", "rigid"]);
Limit.$compared = ["dimension", "least", "most", "open", "rigid"];
$sig(Belt, ["name", "width", "modulus", "rating", "strength", "speed", "kind", "momentary_factor", "least_pulley_diameter", "largest_wrap_pressure", "in_plane_shear_stiffness", "pulley_cover", "carry_cover", "carcass", "thickness", "cover_shear_modulus", "mass", "provenance", "sources"]);
Belt.$compared = ["name", "width", "modulus", "rating", "strength", "speed", "kind", "momentary_factor", "least_pulley_diameter", "largest_wrap_pressure", "in_plane_shear_stiffness", "pulley_cover", "carry_cover", "carcass", "thickness", "cover_shear_modulus", "mass", "provenance", "sources"];
Belt.LIMITS = Belt.prototype.LIMITS = $c4;
$sig(TextOr, ["text", "table"]);
$sig(Flag, []);
$sig(Choice, ["options"]);
$sig(Across, ["shell_profile", "worn_depth", "build_up", "misalignment", "deflection", "entry_profile", "before", "after", "strips"]);
Across.$compared = ["shell_profile", "worn_depth", "build_up", "misalignment", "deflection", "entry_profile", "before", "after", "strips"];
Across.LIMITS = Across.prototype.LIMITS = $c609;
$sig(DimensionText, ["si_unit", "name", "example"]);
DimensionText.$compared = ["si_unit", "name", "example"];
$sig(Definition, ["names", "factor", "unit", "zero"]);
Definition.$compared = ["names", "factor", "unit", "zero"];
$sig(Variant, ["tag", "meaning"], false);
$sig(Variant.prototype.built, ["value", "report"], true);
$sig(Pulley, ["name", "diameter", "wrap_angle", "lagging", "overrun", "recovery", "creep_limit", "side", "mass", "across", "sources", "conditions"]);
Pulley.$compared = ["name", "diameter", "wrap_angle", "lagging", "overrun", "recovery", "creep_limit", "side", "mass", "across", "sources", "conditions"];
Pulley.LIMITS = Pulley.prototype.LIMITS = $c610;
$sig(Sag, ["spacing", "line_mass", "share"]);
Sag.$compared = ["spacing", "line_mass", "share"];
Sag.LIMITS = Sag.prototype.LIMITS = $c611;
$sig(Conveyor, ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio"]);
Conveyor.$compared = ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio"];
Conveyor.LIMITS = Conveyor.prototype.LIMITS = $c612;
$sig(Cost, ["material", "installation", "currency", "area", "life_years"]);
Cost.$compared = ["material", "installation", "currency", "area", "life_years"];
Cost.LIMITS = Cost.prototype.LIMITS = $c613;
$sig(Block, ["shape", "width", "height", "stiffening", "contact_fraction"]);
Block.$compared = ["shape", "width", "height", "stiffening", "contact_fraction"];
Block.LIMITS = Block.prototype.LIMITS = $c614;
$sig(ConditionFactor, ["factor", "source"]);
ConditionFactor.$compared = ["factor", "source"];
ConditionFactor.LIMITS = ConditionFactor.prototype.LIMITS = $c615;
$sig(FrictionFactor, ["at", "factor", "source"]);
FrictionFactor.$compared = ["at", "factor", "source"];
$sig(Fit, ["parameters", "values", "covariance", "residual_noise", "date", "method", "misfit", "misfit_accepted", "coverage_factor"]);
Fit.$compared = ["parameters", "values", "covariance", "residual_noise", "date", "method", "misfit", "misfit_accepted", "coverage_factor"];
$sig(DesignFriction, ["standard", "surface", "condition", "friction", "provenance"]);
DesignFriction.$compared = ["standard", "surface", "condition", "friction", "provenance"];
$sig(Motor, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes"]);
Motor.$compared = ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes"];
Motor.LIMITS = Motor.prototype.LIMITS = $c616;
$sig(VariableSpeed, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "setting", "droop", "torque_limit"]);
VariableSpeed.$compared = ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "setting", "droop", "torque_limit"];
VariableSpeed.LIMITS = VariableSpeed.prototype.LIMITS = $c617;
$sig(Induction, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio"]);
Induction.$compared = ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio"];
Induction.LIMITS = Induction.prototype.LIMITS = $c618;
$sig(FluidCoupling, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio", "coupling_load", "coupling_slip"]);
FluidCoupling.$compared = ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio", "coupling_load", "coupling_slip"];
$sig(Transition, ["length", "trough_angle", "centre_roll", "depth"]);
Transition.$compared = ["length", "trough_angle", "centre_roll", "depth"];
Transition.LIMITS = Transition.prototype.LIMITS = $c619;
$sig(State, ["name", "kind", "resistances", "head", "tail", "entry", "exit"]);
State.$compared = ["name", "kind", "resistances", "head", "tail", "entry", "exit"];
$sig(Resistance, ["name", "carrying", "returning", "source"]);
Resistance.$compared = ["name", "carrying", "returning", "source"];
$sig(OneOrMore, ["kind", "most"]);
$sig(Rows, ["kind", "least", "most"]);
$sig(Constant, ["slip_includes", "friction_coefficient", "tested"]);
Constant.$compared = ["slip_includes", "friction_coefficient", "tested"];
Constant.title = Constant.prototype.title = "constant friction (Euler-Eytelwein)";
$sig(ElasticPlastic, ["slip_includes", "stiffness", "friction_coefficient", "tested"]);
ElasticPlastic.$compared = ["slip_includes", "stiffness", "friction_coefficient", "tested"];
ElasticPlastic.title = ElasticPlastic.prototype.title = "elastic-plastic";
$sig(PressurePower, ["slip_includes", "friction_coefficient", "reference_pressure", "exponent", "tested"]);
PressurePower.$compared = ["slip_includes", "friction_coefficient", "reference_pressure", "exponent", "tested"];
PressurePower.title = PressurePower.prototype.title = "power of pressure";
$sig(Profile, ["dimension", "diameters"], false);
Profile.words = Profile.prototype.words = "rows, or a table";
$sig(GrippingPulley, ["distance"]);
GrippingPulley.$compared = ["distance"];
GrippingPulley.LIMITS = GrippingPulley.prototype.LIMITS = $c1278;
$sig(Count, ["least", "most"]);
$sig(Elsewhere, []);
$sig(Either, ["first", "second", "words"]);
Either.$compared = ["first", "second", "words"];
$sig(SpeedList, []);
SpeedList.$compared = [];
SpeedList.rows = SpeedList.prototype.rows = $c1279;
$sig(_Pair, ["dimension"], false);
$sig(drive_file__drive_from_document, ["document", "file", "folder", "overrides", "allow_paths"], false);
$sig(display__display, ["value", "dimension", "system", "digits"], false);
$sig(tensions__resolve, ["given", "speed", "report", "sure"], false);
export { drive_file__drive_from_document as readDrive };
export { file__train_from_document as readTrain };
export { InputError as InputError };
export { CatalogueBelt as CatalogueBelt };
export { Provenance as Provenance };
export { source__syntax_problem as syntaxProblem };
export { wrap_arc__of_belt as ofBelt };
export { of_data__weak_sources as weakSources };
