# block README MARK: the lines of the fenced block that follows the line MARK; both may be indented alike.
block() {
    awk -v mark="$2" '
        inside && $1 ~ /^```/ { exit }
        inside                { print substr($0, indent + 1) }
        marked && $1 ~ /^```/ { inside = 1 }
        !marked               { indent = match($0, /[^ ]/) - 1; marked = substr($0, indent + 1) == mark }' "$1"
}
