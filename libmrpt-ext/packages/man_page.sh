#!/usr/bin/env bash
# man_page.sh PROGRAM PAGE.1.gz: the man page of an app from its --help, and from man_sections.txt what is true of all.
set -euo pipefail
program=$1 page=$2 name=$(basename "$1")
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

# help2man joins lines into paragraphs: commands and lists of words become what it leaves apart.
asked=$(mktemp -d)
trap 'rm -rf "$asked"' EXIT
cat >"$asked/$name" <<END
#!/bin/sh
exec "$program" "\$@" | sed -E 's/^  ($name) /  \$ \1 /; s/^  ([a-z0-9-]+): /  \1     /'
END
chmod +x "$asked/$name"

summary=$("$program" --help | sed -n 1p)
help2man --no-info --no-discard-stderr --name="${summary,}" --include="$here/man_sections.txt" "$asked/$name" |
  gzip -9 --no-name >"$page"
