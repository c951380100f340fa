# SPDX-License-Identifier: BSD-3-Clause
# Completes octet's commands and options in bash, as --help has them; and files.
_octet() {
  local word=${COMP_WORDS[COMP_CWORD]} words
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    words=$("${COMP_WORDS[0]}" --help |
      awk '/^Subcommands:/ { on = 1; next } /^$/ { on = 0 } on { print $1 }')
    words="$words --help --version"
  elif [[ $word == -* ]]; then
    words=$("${COMP_WORDS[0]}" "${COMP_WORDS[1]}" --help 2>/dev/null |
      awk '/^  -/ { n = split($1, names, ","); for (i = 1; i <= n; ++i) print names[i] }')
  else
    return
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
}
complete -o default -F _octet octet
