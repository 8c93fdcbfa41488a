"""Programs that end in an error, and programs with random damage."""
import re

from . import literals


class Errors:
    """Mixin of the generator."""

    # Content that must never be looked at.
    BROKEN = ['<x a="${nothing}"/>', '<xacro:no_such_macro/>', '<x a="$${"/><y b="$$z"/>', '<xacro:include filename="gone.xacro"/>', '${1 +}',
              '<xacro:insert_block name="nowhere"/>', '<x a="${1 / 0}"/>', '<xacro:property/>', "<x a=\"${xacro.fatal('no')}\"/>", '<xacro:if/>',
              '<xacro:attribute/>', '$(arg nothing)', '<xacro:element/>', '<xacro:property name="__x" value="1"/>', '<xacro:macro name="a.b"/>']

    MISTAKES = [
        '<x a="${nothing_like_it}"/>', '<x a="${1 / 0}"/>', '<x a="${1 % 0}"/>', '<x a="${1.5 // 0}"/>', '<x a="${\'a\' + 1}"/>', '<x a="${[1][5]}"/>',
        '<x a="${dict(a=1)[\'b\']}"/>', '<x a="${sqrt(-1)}"/>', '<x a="${int(\'x\')}"/>', '<x a="${1 +}"/>', '<x a="${(1}"/>', '<x a="${}"/>', '<x a="${  }"/>',
        '<x a="${x = 1}"/>', '<x a="${import os}"/>', '<x a="${\'}\'}"/>', '<x a="$$x"/>', '<x a="${1"/>', '<x a="$(arg"/>', '<x a="$(arg nothing)"/>',
        '<x a="$(env NOT_SET)"/>', '<x a="$(find no_such_package)"/>', '<x a="$(unknown x)"/>', '<x a="$(dirname)"/>', '<x a="$( )"/>', '<x a="$(arg a b)"/>', '<x a="$(arg)"/>',
        '<x a="$(eval nothing)"/>', '<x a="$(eval 1 +)"/>', '<x a="$(eval __x)"/>', '<x a="$(anon x)"/>', '<x a="$(find)"/>',
        '<x a="${\'\'.__class__}"/>', '<x a="${__import__}"/>', '<x a="${abs(1)}"/>', '<x a="${open}"/>', '<x a="${print(1)}"/>', '<x a="${math.nothing}"/>',
        '<x a="${\'x\'.nothing()}"/>', '<x a="${5()}"/>', '<x a="${len()}"/>', '<x a="${len(5)}"/>', '<x a="${None + 1}"/>', '<x a="${\'%d\' % \'x\'}"/>', '<x a="${[] &lt; 1}"/>',
        '<x a="${-\'a\'}"/>', '<x a="${\'abc\'.index(\'z\')}"/>', '<x a="${max([])}"/>', '<x a="${dict(a=1).a}"/>', '<x a="${xacro.fatal(\'stop\', 1)}"/>', '<x a="${xacro.nothing}"/>',
        '<x a="${xacro.load_yaml(\'gone.yaml\')}"/>', '<x a="${10 ** 400 * 1.0}"/>', '<x a="${1 &lt;&lt; -1}"/>', '<x a="${[i for i in 5]}"/>', '<x a="${(lambda a: a)()}"/>',
        '<x a="${float(\'abc\')}"/>', '<x a="${\'a\' in 5}"/>', '<x a="${[1, 2].nothing}"/>', '<x a="${012}"/>', '<x a="${1 2}"/>', '<x a="${a b}"/>', '<x a="${\'abc}"/>',
        '<xacro:no_such_macro/>', '<xacro:no.such/>', '<xacro:call/>', '<xacro:call macro=""/>', '<xacro:call macro="nothing"/>', '<xacro:insert_block name="nowhere"/>', '<xacro:insert_block/>',
        '<xacro:if value="maybe"><a/></xacro:if>', '<xacro:if value="1.0"/>', '<xacro:if value=""/>', '<xacro:unless value="yes"/>', '<xacro:if/>', '<xacro:if value="${\'abc\'}"/>',
        '<xacro:if value="TRUE"/>', '<xacro:if value=" true "/>', '<xacro:property value="1"/>', '<xacro:property name="" value="1"/>', '<xacro:property name="a-b" value="1"/>',
        '<xacro:property name="1a" value="1"/>', '<xacro:property name="class" value="1"/>', '<xacro:property name="__a" value="1"/>', '<xacro:property name="a.b" value="1"/>',
        '<xacro:property name="pa" value="1" default="2"/>', '<xacro:property name="pa" value="1" remove="true"/>', '<xacro:property name="pa" value="1" lazy_eval="maybe"/>',
        '<xacro:property name="pa" value="1" remove="x"/>', '<xacro:property name="pc" value="${pc}"/><x a="${pc}"/>',
        '<xacro:property name="pd" value="${pf}"/><xacro:property name="pf" value="${pd}"/><x a="${pf}"/>', '<xacro:property name="pp" value="1" scope="parent"/>',
        '<xacro:macro name="call"/>', '<xacro:macro name="a.b"/>', '<xacro:macro/>', '<xacro:macro name="mz" params="  "/>', '<xacro:arg name="aa"/>', '<xacro:arg default="1"/>',
        '<xacro:include filename="gone.xacro"/>', '<xacro:include/>', '<xacro:include filename=""/>', '<xacro:include filename="sub"/>', '<xacro:include filename="${nothing}"/>',
        '<xacro:include filename="gone.xacro" optional="maybe"/>', '<xacro:include filename="gone.xacro" optional="false"/>', '<xacro:include filename="data0.xml"/>',
        '<xacro:element/>', '<xacro:element xacro:name=""/>', '<xacro:element xacro:name="${1}"/>', '<xacro:attribute name="a"/>', '<xacro:attribute name="" value="1"/>',
        '<xacro:macro name="em" params="p"><y a="${p}"/></xacro:macro><xacro:em/>', '<xacro:macro name="em" params="p"/><xacro:em p="1" z="2"/>',
        '<xacro:macro name="em" params="*p"/><xacro:em/>', '<xacro:macro name="em" params="*p"/><xacro:em><a/><b/></xacro:em>', '<xacro:macro name="em"/><xacro:em><a/></xacro:em>',
        '<xacro:macro name="em" params="p:=^"/><xacro:em/>', '<xacro:macro name="em" params="p:=${nothing}"/><xacro:em/>', '<xacro:macro name="em" params="p:="/><xacro:em/>',
        '<xacro:macro name="em" params="p p"/><xacro:em p="1"/>', '<xacro:macro name="em"><xacro:em/></xacro:macro><xacro:em/>',
        '<xacro:macro name="em" params="p"><xacro:property name="in_em" value="${p}"/></xacro:macro><xacro:em p="1"/><x a="${in_em}"/>',
        '<xacro:macro name="em"><xacro:macro name="en"/></xacro:macro><xacro:em/><xacro:en/>', '<xacro:macro name="em" params="p q:=${p}"/><xacro:em p="1"/>',
        '<!-- xacro:eval-comments --><!-- ${nothing} -->', '<x>${nothing}</x>', 'text ${1 +} text', '<x><y><z a="${nothing}"/></y></x>',
        '<xacro:property name="lazy_bad" value="${nothing}"/><x a="${lazy_bad}"/>', '<xacro:property name="lazy_ok" value="${later}"/><x a="${lazy_ok}"/><xacro:property name="later" value="1"/>',
        '<x a="1" a="2"/>', '<x a=1/>', '<x a="<"/>', '<x a="&nothing;"/>', '<x>&amp</x>', '<x>', '</x>', '<x></y>', '<un:bound/>', '<x un:bound="1"/>', '<!-- a -- b -->', '<x a="1"b="2"/>',
        '<1x/>', '< x/>', '<x>]]></x>', '<![CDATA[', '<?xml version="1.0"?>', '<x a="\x01"/>', '&#0;', '<x a>', '<x/ >', '<!DOCTYPE x>',
    ]

    def inject(self, nodes, ctx):
        """Put a mistake somewhere."""
        text = self.rng.choice(self.MISTAKES)
        roll = self.rng.random()
        if roll < 0.2:
            text = '<xacro:macro name="holds_error"><in>%s</in></xacro:macro><xacro:holds_error/>' % text
        elif roll < 0.35:
            path = self.new_file(ctx)
            self.files[path] = '<robot xmlns:xacro="urn:x"><a/>%s</robot>' % text
            text = '<xacro:include filename="%s"/>' % path
        elif roll < 0.45:
            text = '<xacro:if value="1">%s</xacro:if>' % text
        elif roll < 0.55:
            text = '<xacro:property name="holds_error"><b>%s</b></xacro:property><xacro:insert_block name="holds_error"/>' % text
        nodes.insert(self.rng.randrange(len(nodes) + 1), text)

    def mutate(self, program):
        """Damage a text file of the program in one to three places."""
        rng = self.rng
        for _ in range(rng.choice([1, 1, 2, 3])):
            path = rng.choice([p for p in program.files if p.endswith(('.xacro', '.yaml', '.yml'))] + ['input.xacro'] * 3)
            text = program.files[path].decode('utf-8', 'replace')
            if len(text) > 10:
                program.files[path] = rng.choice([self.cut, self.swap, self.double, self.retype, self.rename])(text).encode()

    def cut(self, text):
        """Leave some characters out."""
        start = self.rng.randrange(len(text))
        return text[:start] + text[start + self.rng.choice([1, 1, 1, 2, 5, 30]):]

    def swap(self, text):
        """Swap two lines."""
        lines = text.split('\n')
        i, j = self.rng.randrange(len(lines)), self.rng.randrange(len(lines))
        lines[i], lines[j] = lines[j], lines[i]
        return '\n'.join(lines)

    def double(self, text):
        """Repeat a line."""
        lines = text.split('\n')
        i = self.rng.randrange(len(lines))
        return '\n'.join(lines[:i + 1] + lines[i:])

    def retype(self, text):
        """Put another character in."""
        at = self.rng.randrange(len(text))
        return text[:at] + self.rng.choice(list('${}()<>/&"\'=:;,. \n[]%*+-x0!#@\\|^~_é')) + text[at + self.rng.randrange(2):]

    def rename(self, text):
        """Replace one word by another of the text."""
        words = re.findall(r'\w+', text)
        old, new = self.rng.choice(words or ['a']), self.rng.choice(words + [self.rng.choice(literals.WORDS)])
        places = [m.start() for m in re.finditer(re.escape(old), text)]
        at = self.rng.choice(places) if places else 0
        return text[:at] + new + text[at + len(old):]
