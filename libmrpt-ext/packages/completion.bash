# Completion for the apps of mrpt_ext in bash: what the app answers to --help and --list-keys.  -*- shell-script -*-

# _mrpt_ext APP WORD PREVIOUS: as bash calls it
_mrpt_ext()
{
  local app=$1 word=$2 previous=$3 help choices=
  help=$("$app" --help 2>/dev/null) || return
  case $previous in
    --set | --explain)
      choices=$("$app" --list-keys 2>/dev/null | awk '
        /^\[/ { section = substr($1, 2, length($1) - 2) }
        section !~ /</ && /^[* ] [A-Za-z]/ { sub(/^../, ""); print section "." $1 }')
      if [ "$previous" = --set ]; then
        compopt -o nospace
        choices=${choices//$'\n'/=$'\n'}=
      fi
      ;;
    --*) # an option whose values the help lists: {a,b,c}
      choices=$(sed -nE "s/^ +(-[a-z],)?$previous .*\{([^}]*)\}.*/\2/p" <<<"$help" | tr , ' ')
      ;;
  esac
  if [ -z "$choices" ] && [[ $word == -* ]]; then
    choices=$(sed -nE 's/^  (-[a-z],)?(--[a-z-]+).*/\2/p' <<<"$help")
  elif [ -z "$choices" ] && [ "$COMP_CWORD" -eq 1 ]; then # a first word that the help lists: the format of dataset2rawlog
    choices=$(sed -nE 's/^  ([a-z0-9-]+): .*/\1/p' <<<"$help")
  fi
  # Without an answer bash completes files.
  mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$word")
}
complete -o default -F _mrpt_ext dataset2rawlog images2rawlog landmark-localization landmark-simulator localization-report
