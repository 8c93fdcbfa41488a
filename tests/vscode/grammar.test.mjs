// The TextMate grammars, as VS Code runs them: with the injections of package.json.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import test, { before } from "node:test";
import { fileURLToPath } from "node:url";

const require = createRequire(import.meta.url);
const { INITIAL, Registry, parseRawGrammar } = require("vscode-textmate");
const { OnigScanner, OnigString, loadWASM } = require("vscode-oniguruma");

const repository = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const extension = join(repository, "editors", "vscode");
const { contributes } = JSON.parse(readFileSync(join(extension, "package.json"), "utf8"));
let grammar;

before(async () => {
  await loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new OnigScanner(patterns),
      createOnigString: (text) => new OnigString(text),
    }),
    loadGrammar: async (scope) => {
      const file = contributes.grammars.find(({ scopeName }) => scopeName === scope);
      return file ? parseRawGrammar(readFileSync(join(extension, file.path), "utf8"), file.path) : null;
    },
    getInjections: (scope) =>
      contributes.grammars.filter(({ injectTo }) => injectTo?.includes(scope)).map(({ scopeName }) => scopeName),
  });
  grammar = { xacro: await registry.loadGrammar("text.xml.xacro"), urdf: await registry.loadGrammar("text.xml.urdf") };
});

/** The tokens of a text: what stands there, and its scopes from the outside in. */
function tokens(text, language = "xacro") {
  let stack = INITIAL;
  return text.split("\n").flatMap((line) => {
    const result = grammar[language].tokenizeLine(line, stack);
    stack = result.ruleStack;
    return result.tokens.map(({ startIndex, endIndex, scopes }) => ({ text: line.slice(startIndex, endIndex), scopes }));
  });
}

/** Scopes of the n-th token that is this text. */
function scopesOf(source, part, { language = "xacro", nth = 1 } = {}) {
  const all = tokens(source, language);
  const found = all.filter(({ text }) => text.trim() === part)[nth - 1];
  assert.ok(found, `no token ${part} in ${JSON.stringify(all.map(({ text }) => text))}`);
  return found.scopes.join(" ");
}

const TABLE = [
  // source, token, a scope it has
  ['<link name="a"/>', "link", "entity.name.tag.localname.xml"],
  ['<link name="a"/>', "name", "entity.other.attribute-name.localname.xml"],
  ['<link name="a"/>', "a", "string.quoted.double.xml"],
  ["<link name='a'/>", "a", "string.quoted.single.xml"],
  ["</link>", "link", "entity.name.tag.localname.xml"],
  ['<robot xmlns:xacro="x">', "xmlns", "entity.other.attribute-name.namespace.xml"],
  ['<xacro:if value="1">', "if", "keyword.control.directive.xacro"],
  ["</xacro:unless>", "unless", "keyword.control.directive.xacro"],
  ['<xacro:leg side="left"/>', "leg", "entity.name.function.macro.xacro"],
  ['<xacro:iffy side="left"/>', "iffy", "entity.name.function.macro.xacro"],
  ['<origin xyz="0 -1.5e-3 2"/>', "-1.5e-3", "constant.numeric.xml"],
  ['<a b="x &lt; y"/>', "&lt;", "constant.character.entity.xml"],
  ["<!-- a link -->", "a link", "comment.block.xml"],
  ["<!-- xacro-lint: disable-file -->", "disable-file", "keyword.other.directive.xacro"],
  ["<![CDATA[ ${a} ]]>", "${a}", "string.unquoted.cdata.xml"],
  ['<?xml version="1.0"?>', "xml", "meta.tag.preprocessor.xml"],
  // expressions in values
  ['<a b="${width * 2}"/>', "width", "variable.other.readwrite.xacro"],
  ['<a b="${width * 2}"/>', "*", "keyword.operator.xacro"],
  ['<a b="${width * 2}"/>', "2", "constant.numeric.xacro"],
  ['<a b="${radians(90)}"/>', "radians", "support.function.xacro"],
  ['<a b="${2 * pi}"/>', "pi", "support.constant.math.xacro"],
  ['<a b="${limits.lower}"/>', "lower", "variable.other.property.xacro"],
  ["<a b=\"${cam['fov']}\"/>", "'fov'", "string.quoted.single.xacro"],
  ["<a b=\"${xacro.load_yaml('f')}\"/>", "load_yaml", "support.function.xacro"],
  ['<a b="${x if not y else None}"/>', "not", "keyword.operator.word.xacro"],
  ['<a b="${x if not y else None}"/>', "None", "constant.language.xacro"],
  ['<a b="${n &lt;= 6}"/>', "&lt;", "keyword.operator.entity.xacro"],
  ["<a b='${cam[\"fov\"]}'/>", '"fov"', "string.quoted.double.xacro"],
  ['<a>${width}</a>', "width", "meta.embedded.expression.xacro"],
  ['<a>${cam["fov"]}</a>', '"fov"', "string.quoted.double.xacro"],
  // substitutions
  ['<a b="$(find pkg)/x"/>', "find", "keyword.other.substitution.xacro"],
  ['<a b="$(find pkg)/x"/>', "pkg", "entity.name.namespace.package.xacro"],
  ['<a b="$(arg side)"/>', "side", "variable.other.argument.xacro"],
  ['<a b="$(eval 1 + x)"/>', "eval", "keyword.other.substitution.xacro"],
  // an escaped dollar is no expression
  ['<a b="$${width}"/>', "$$", "constant.character.escape.xacro"],
  // parameters
  ['<xacro:macro name="m" params="a b:=1 *c **d e:=^|2">', "a", "variable.parameter.xacro"],
  ['<xacro:macro name="m" params="a b:=1 *c **d e:=^|2">', "**", "storage.modifier.block.xacro"],
  ['<xacro:macro name="m" params="a b:=1 *c **d e:=^|2">', "^|", "keyword.operator.forward.xacro"],
  ['<xacro:macro name="m" params="a:=${2 * k}">', "k", "variable.other.readwrite.xacro"],
];

for (const [source, part, scope] of TABLE) {
  test(`${source}: ${part} is ${scope}`, () => {
    const scopes = scopesOf(source, part);
    assert.ok(scopes.split(" ").includes(scope), scopes);
  });
}

test("the language urdf has the same colours", () => {
  assert.match(scopesOf('<a b="${width}"/>', "width", { language: "urdf" }), /variable\.other\.readwrite\.xacro/);
});

test("what is half-typed ends with its value", () => {
  for (const [source, part] of [
    ['<a b="${width" c="d"/>', "c"],
    ['<a b="$(find pkg" c="d"/>', "c"],
    ["<a b='${width' c='d'/>", "c"],
  ]) {
    assert.match(scopesOf(source, part), /entity\.other\.attribute-name/);
  }
  assert.match(scopesOf("<a>${width</a>", "a", { nth: 2 }), /entity\.name\.tag/);
  assert.match(scopesOf('<link name="a"\n<joint name="b"/>', "joint"), /entity\.name\.tag/);
});

test("an expression may go on in the next line", () => {
  assert.match(scopesOf('<a b="${width\n  + height}"/>', "height"), /variable\.other\.readwrite\.xacro/);
});

test("comments hold no expressions", () => {
  assert.doesNotMatch(scopesOf("<!-- ${width} -->", "${width}"), /meta\.embedded/);
});

test("every example is read to its end", () => {
  const folder = join(repository, "docs", "examples");
  const files = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".xacro"));
  assert.ok(files.length > 10);
  for (const name of files) {
    const last = tokens(readFileSync(join(folder, name), "utf8").trimEnd()).at(-1);
    assert.equal(last.text, ">", name);
    assert.ok(last.scopes.includes("punctuation.definition.tag.end.xml"), `${name}: ${last.scopes.join(" ")}`);
  }
});
