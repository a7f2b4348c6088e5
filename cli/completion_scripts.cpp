// SPDX-License-Identifier: Apache-2.0
#include "cli/completion_scripts.h"

namespace hapticell::cli {

namespace {

constexpr std::string_view kBash =
    R"script(# bash completion of HaptiCell's programs, made by: hapticell-cli completion bash
_hapticell_cli() {
  local current=${COMP_WORDS[COMP_CWORD]} program=$1 line word file
  local -a known=("${COMP_WORDS[@]:1:COMP_CWORD}") words=()
  # Words with a colon or an equals sign are one.
  if declare -F _get_comp_words_by_ref >/dev/null; then
    local cword
    _get_comp_words_by_ref -n := -c current -w words -i cword
    known=("${words[@]:1:cword}")
  fi
  COMPREPLY=()
  while IFS= read -r line; do
    word=${line%%$'\t'*}
    case $word in
      :folders)
        compopt -o filenames
        while IFS= read -r file; do COMPREPLY+=("$file"); done < <(compgen -d -- "$current") ;;
      :files*)
        compopt -o filenames
        while IFS= read -r file; do
          local ending=${file##*.}
          if [[ $word == :files || -d $file || " ${word#:files } " == *" ${ending,,} "* ]]; then COMPREPLY+=("$file"); fi
        done < <(compgen -f -- "$current") ;;
      "$current"*) COMPREPLY+=("$word") ;;
    esac
  done < <("$program" completion words "${known[@]}" 2>/dev/null)
  if declare -F __ltrim_colon_completions >/dev/null; then __ltrim_colon_completions "$current"; fi
}
_hapticell_options() {
  local current=${COMP_WORDS[COMP_CWORD]}
  if [[ $current == -* ]]; then
    local options
    options=$("$1" --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]+' | sort -u)
    while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -W "$options" -- "$current")
  else
    compopt -o filenames
    while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen -f -- "$current")
  fi
}
complete -F _hapticell_cli hapticell-cli
complete -F _hapticell_options hapticell hapticell-haptic-server hapticell-importer hapticell-ros2
)script";

constexpr std::string_view kZsh = R"script(#compdef hapticell-cli hapticell hapticell-haptic-server hapticell-importer hapticell-ros2
# zsh completion of HaptiCell's programs, made by: hapticell-cli completion zsh
_hapticell_cli() {
  local line word
  local -a described endings
  for line in ${(f)"$(${words[1]} completion words "${(@Q)words[2,CURRENT]}" 2>/dev/null)"}; do
    word=${line%%$'\t'*}
    case $word in
      (:folders) _files -/ ;;
      (:files) _files ;;
      (:files*)
        endings=(${=word#:files })
        _files -g "*.(#i)(${(j:|:)endings})" ;;
      (*) described+=("${word//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  (( $#described )) && _describe -o word described
}
if [[ ${service:-hapticell-cli} == hapticell-cli ]]; then
  _hapticell_cli "$@"
else
  _arguments -s --  '*:file:_files'
fi
)script";

constexpr std::string_view kFish =
    R"script(# fish completion of HaptiCell's programs, made by: hapticell-cli completion fish
function __hapticell_cli_words
  set -l words (commandline -opc)
  set -l current (commandline -ct)
  for line in ($words[1] completion words $words[2..-1] "$current" 2>/dev/null)
    switch $line
      case ':folders*'
        __fish_complete_directories "$current"
      case ':files*'
        set -l endings (string split ' ' -- (string replace -r '^:files ?' '' -- $line))
        for file in (__fish_complete_path "$current")
          set -l path (string split -f 1 \t -- $file)
          set -l ending (string lower -- (string replace -r '^.*\.' '' -- $path))
          if test -z "$endings"; or string match -q '*/' -- $path; or contains -- $ending $endings
            echo $file
          end
        end
      case '*'
        echo $line
    end
  end
end
function __hapticell_options
  $argv[1] --help 2>/dev/null | string match -ra -- '--[a-z][a-z-]+' | sort -u
end
complete -c hapticell-cli -f -a '(__hapticell_cli_words)'
for program in hapticell hapticell-haptic-server hapticell-importer hapticell-ros2
  complete -c $program -n 'string match -q -- "-*" (commandline -ct)' -f -a "(__hapticell_options $program)"
end
)script";

}  // namespace

std::string_view completionScript(std::string_view shell) {
  if (shell == "bash") return kBash;
  if (shell == "zsh") return kZsh;
  return shell == "fish" ? kFish : std::string_view();
}

}  // namespace hapticell::cli
