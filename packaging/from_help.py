#!/usr/bin/env python3
"""Man pages and completions of a program, from its help alone: from_help.py PROGRAM FOLDER

Writes FOLDER/man/isoloop.1, one page for each command, FOLDER/bash/isoloop and FOLDER/zsh/_isoloop.
"""

import pathlib
import re
import subprocess
import sys
from typing import NamedTuple

COLUMN = 30  # where the help's explanations begin


class Option(NamedTuple):
    names: list[str]  # "-o", "--output"
    value: str  # "FILE", or empty
    words: list[str]  # that it takes, where these are all
    text: str


class Help(NamedTuple):
    about: str
    usage: str
    positionals: list[tuple[str, str]]
    options: list[Option]
    commands: list[tuple[str, str]]
    footer: list[str]


def help_of(program, command=""):
    words = [program, *([command, "--help-all"] if command else ["-h"])]
    lines = subprocess.run(words, capture_output=True, check=True, text=True).stdout.splitlines()
    sections, name = {"": []}, ""
    for line in lines[2:]:
        if re.fullmatch(r"[A-Z][^:]*:", line):
            name = line[:-1]
            if name not in ("Positionals", "Subcommands", "Examples"):
                name = "Options"  # by groups
            sections.setdefault(name, [])
        else:
            sections[name].append(line)
    rows = {key: rows_of(sections.get(key, [])) for key in ("Positionals", "Options", "Subcommands")}
    return Help(
        lines[0],
        lines[1].removeprefix("Usage: "),
        [(head.removesuffix(" REQUIRED"), text) for head, text in rows["Positionals"]],
        [option_of(head, text) for head, text in rows["Options"]],
        rows["Subcommands"],
        sections.get("Examples", []),
    )


def rows_of(lines):
    """Heads and explanations, which stand beside them or, of long heads, below."""
    rows = []
    for line in lines:
        if line.startswith(" " * COLUMN):
            rows[-1] = (rows[-1][0], line.strip())
        elif line.strip():
            head, text = line[:COLUMN], line[COLUMN:]
            if head and not head.endswith(" ") and text:
                head, text = line, ""
            rows.append((head.strip(), text.strip()))
    return rows


def option_of(head, text):
    head = re.sub(r" (REQUIRED|Excludes: .*)", "", head)
    names, _, value = head.partition(" ")
    words = re.search(r":\{(.*?)\}", value)
    value = re.sub(r":\{.*?\}", "", value)
    return Option(names.split(","), value, words[1].split(",") if words else [], text)


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("χ", "\\(*x")
    return "\\&" + text if text.startswith((".", "'")) else text


def man_page(name, version, page, others):
    title = name.upper().replace(" ", "-")
    dashed = name.replace(" ", "-")
    out = [f'.TH {roff(title)} 1 "" "isoloop {version}" "User Commands"', ".SH NAME"]
    first = page.about.rstrip(".")
    out += [f"{roff(dashed)} \\- {roff(first)}", ".SH SYNOPSIS", f".B {roff(page.usage)}"]
    if page.positionals or page.commands:
        out.append(".SH " + ("COMMANDS" if page.commands else "ARGUMENTS"))
    for head, text in page.positionals + page.commands:
        out += [".TP", f".B {roff(head)}", roff(text)]
    out.append(".SH OPTIONS")
    for option in page.options:
        value = option.value + (" (" + ", ".join(option.words) + ")" if option.words else "")
        out += [".TP", f".BR {roff(', '.join(option.names)).replace(' ', chr(92) + ' ')}"]
        out[-1] += f' " {roff(value)}"' if value else ""
        out.append(roff(option.text))
    examples = [line for line in page.footer if line.startswith("  ")]
    if examples:
        out += [".SH EXAMPLES", ".nf", *(roff(line.strip()) for line in examples), ".fi"]
    codes = [line for line in page.footer if line.startswith("Exit codes")]
    if codes:
        out += [".SH EXIT STATUS", roff(codes[0].removeprefix("Exit codes: "))]
    out += [".SH SEE ALSO"]
    out.append(",\n".join(f".BR {roff(other)} (1)" for other in others if other != dashed).replace(
        ",\n", " ,\n"))
    return "\n".join(out) + "\n"


def bash(commands):
    """`commands`: their names with their help."""
    cases = []
    for name, page in commands.items():
        flags = " ".join(flag for option in page.options for flag in option.names)
        cases.append(f"    {name}) flags='{flags}' ;;")
    words = {}
    for page in commands.values():
        for option in page.options:
            if option.words:
                words[option.names[-1]] = " ".join(option.words)
    shapes = shapes_of(commands)
    values = "\n".join(f"    {flag}) words='{its}' ;;" for flag, its in sorted(words.items()))
    return f"""# bash completion of isoloop, made from its help
_isoloop() {{
  local flags='' words='' now=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W '{" ".join(commands)} -h --help --version' -- "$now")
    return
  fi
  case $before in
{values}
    generate) words='{shapes}' ;;
  esac
  if [[ -n $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$now")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{chr(10).join(cases)}
  esac
  if [[ $now == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$flags" -- "$now")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$now")
    compopt -o filenames 2>/dev/null
  fi
}}
complete -F _isoloop isoloop
"""


def shapes_of(commands):
    if "generate" not in commands:
        return ""
    return commands["generate"].positionals[0][1].removeprefix("one of ").replace(",", "")


def zsh(commands):
    def quoted(text):
        return re.sub(r"([\[\]:'])", lambda mark: "'\\''" if mark[1] == "'" else "\\" + mark[1], text)

    cases = []
    for name, page in commands.items():
        rows = []
        for option in page.options:
            for flag in option.names:
                value = ""
                if option.value:
                    name_of_value = quoted(option.value.split("=")[0])
                    does = f"({' '.join(option.words)})" if option.words else "_files"
                    value = f":{name_of_value}:{does}"
                rows.append(f"      '*{flag}[{quoted(option.text)}]{value}'")
        takes = f"({shapes_of(commands)})" if name == "generate" else "_files"
        rows.append(f"      '*:file:{takes}'")
        cases.append(f"    {name}) _arguments \\\n" + " \\\n".join(rows) + " ;;")
    names = "\n".join(f"    '{name}:{quoted(page.about)}'" for name, page in commands.items())
    return f"""#compdef isoloop
# zsh completion of isoloop, made from its help
local -a commands
if ((CURRENT == 2)); then
  commands=(
{names}
  )
  _describe command commands
  return
fi
local command=$words[2]
shift words
((CURRENT--))
case $command in
{chr(10).join(cases)}
esac
"""


def main(program, folder):
    top = help_of(program)
    said = subprocess.run([program, "--version"], capture_output=True, check=True, text=True)
    version = said.stdout.split()[1]
    commands = {name: help_of(program, name) for name, _ in top.commands}
    pages = ["isoloop", *(f"isoloop-{name}" for name in commands)]
    made = {"man/isoloop.1": man_page("isoloop", version, top, pages)}
    for name, page in commands.items():
        made[f"man/isoloop-{name}.1"] = man_page(f"isoloop {name}", version, page, pages)
    made["bash/isoloop"] = bash(commands)
    made["zsh/_isoloop"] = zsh(commands)
    for name, text in made.items():
        path = pathlib.Path(folder) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
