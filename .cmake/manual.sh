#!/bin/bash
# manual.sh PROGRAM VERSION MANUAL COMPLETION
# Writes the man page and the completion for bash, both from what the program says of itself.
set -euo pipefail
program=$1 version=$2 manual=$3 completion=$4

verbs=$("$program" --help | awk '/^Subcommands:/ { on = 1; next } on && NF { print $1 }')
[ -n "$verbs" ] || { echo "manual: $program names no verb (is it overturn?)" >&2; exit 1; }

# Text as roff takes it literally.
literally() { sed -e 's/\\/\\e/g' -e 's/-/\\-/g' -e "s/^\\([.']\\)/\\\\\\&\\1/"; }

# A verb's help as a section: what it does, how it is called, its arguments.
section() {
    "$program" "$1" --help | literally | awk -v verb="$1" '
        NR == 1 { printf ".SS %s\n%s.\n", verb, $0; next }
        /^Usage:/ { sub(/^Usage: /, ""); printf ".PP\n.B %s\n", $0; next }
        /^(Positionals|Options):$/ { next }
        /^  [^ ]/ {
            text = substr($0, 3)
            at = match(text, /  +/)
            name = at ? substr(text, 1, at - 1) : text
            printf ".TP\n.B %s\n%s\n", name, at ? substr(text, at + RLENGTH) : ""
            next
        }
        NF { sub(/^ +/, ""); print }'
}

{
    echo ".TH OVERTURN 1 \"\" \"overturn $version\" \"User Commands\""
    printf '.SH NAME\noverturn \\- overturning of free\\-standing bodies in earthquakes\n.SH SYNOPSIS\n.B overturn\nVERB [OPTIONS]\n'
    printf '.SH DESCRIPTION\nFragility campaigns (alone or under mpirun) and single trials. A campaign is a TOML file, its results one HDF5 file.\n'
    echo ".SH VERBS"
    for verb in $verbs; do section "$verb"; done
    printf '.SH EXIT STATUS\n.TP\n.B 0\ndone\n.TP\n.B 2\nbad input: one line, file:line:col: problem (why) what to do\n'
    printf '.TP\n.B 3\nstopped early and resumable\n.TP\n.B 4\nfit: the curves that the file holds are other ones\n.TP\n.B 1\nanything else\n'
    printf '.SH ENVIRONMENT\n.TP\n.B OVERTURN_PYTHON\nthe Python that draws figures; default: /usr/bin/python3, else python3 from PATH; PYTHONPATH and PYTHONHOME are not looked at\n'
} > "$manual"

# Options that a verb takes, long and short.
options() { "$program" "$1" --help | grep -oE '^  -[^ ]+' | tr -d ' ' | tr ',' '\n' | sort -u | tr '\n' ' '; }

# Tables of a campaign, as `list keys` takes their names.
tables() { "$program" list keys | grep -oE '^\[+[a-z_.]+' | tr -d '[' | sort -u | tr '\n' ' '; }

{
    echo "# Completion of overturn for bash: verbs, their options, else names of files."
    echo "_overturn() {"
    echo "    local word=\${COMP_WORDS[COMP_CWORD]} words"
    echo "    if [ \"\$COMP_CWORD\" -eq 1 ]; then"
    echo "        words=\"$(tr '\n' ' ' <<< "$verbs")--help --version\""
    echo "    else"
    echo "        case \${COMP_WORDS[1]} in"
    for verb in $verbs; do echo "            $verb) words=\"$(options "$verb")\" ;;"; done
    echo "        esac"
    echo "        [[ \$word == -* ]] || words=''"
    # What `list` lists, and the tables that keys are in.
    echo "        [ \"\${COMP_WORDS[1]} \$COMP_CWORD\" != 'list 2' ] || words=\"assumptions keys \$words\""
    echo "        [ \"\${COMP_WORDS[*]:1:2} \$COMP_CWORD\" != 'list keys 3' ] || words=\"$(tables)\$words\""
    echo "    fi"
    echo "    mapfile -t COMPREPLY < <(compgen -W \"\$words\" -- \"\$word\")"
    echo "}"
    echo "complete -o default -F _overturn overturn"
} > "$completion"
