# Bash completion for seiche; installed where bash-completion finds it, or: source seiche-completion.bash
_seiche() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} program=${COMP_WORDS[0]}
  local words
  case $previous in
    --tier) words="quick full paper" ;;
    --as) words=$("$program" list --published 2>/dev/null | sed -n 's/^seiche run .* --as //p' | tr -d ,) ;;
    --format) words="csv json hdf5" ;;
    --write) words="openfoam dualsphysics geoclaw vtk csv" ;;
    --baseline | --centres | --config | --data | --out | --pdf) COMPREPLY=($(compgen -f -- "$word")); return ;;
    *)
      if ((COMP_CWORD == 1)); then
        words="$("$program" --help 2>/dev/null | awk '/^[A-Z].*:$/ {on = !/^(Options|Positionals):/} on && /^  [a-z]/ {print $1}') --help --version"
      elif [[ $word == -* ]]; then
        words=$("$program" "${COMP_WORDS[1]}" --help 2>/dev/null | grep -o -- '--[a-z-]*')
      else
        case ${COMP_WORDS[1]} in
          run | score | exact) words=$("$program" list 2>/dev/null | awk '/^  [a-z]/ {print $1}') ;;
          report | compare | record) COMPREPLY=($(compgen -d -- "$word")); return ;;
        esac
      fi
      ;;
  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}
complete -F _seiche seiche
