# Sourced by the scripts of this folder: a Debian of its own to run commands in. Needs root and debootstrap.

# need_chroot NAME: ends the script NAME with one line when there is no way to make one.
need_chroot() {
  [ "$(id -u)" -eq 0 ] || { echo "$1: a chroot needs root" >&2; exit 1; }
  command -v debootstrap >/dev/null || { echo "$1: no debootstrap: apt-get install debootstrap" >&2; exit 1; }
}

# make_chroot RELEASE CHROOT: once; MIRROR names another Debian mirror. The settings that apt needs on this machine hold
# there too: proxies, mirrors of this network.
make_chroot() {
  local release=$1 chroot=$2 setting
  if [ ! -f "$chroot/etc/debian_version" ]; then
    debootstrap --variant=minbase "$release" "$chroot" "${MIRROR:-http://deb.debian.org/debian}" | tail -n 1
  fi
  cp /etc/resolv.conf "$chroot/etc/" 2>/dev/null || true
  for setting in /etc/apt/apt.conf.d/*proxy*; do
    [ ! -e "$setting" ] || cp "$setting" "$chroot/etc/apt/apt.conf.d/"
  done
}

# in_chroot CHROOT COMMAND [USER]: as that user in the own home; as root in /src, if there is one, without.
in_chroot() {
  local as=()
  [ -z "${3:-}" ] || as=(setpriv --reuid "$3" --regid "$3" --clear-groups)
  chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy=$http_proxy} ${https_proxy:+https_proxy=$https_proxy} \
    "${as[@]}" bash -c "export HOME=~; cd /src 2>/dev/null || cd; $2"
}
