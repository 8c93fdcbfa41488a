"""Files to check: the bad examples of docs/rules/, written to a folder."""
import glob
import os

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def write(folder):
    """Write the bad blocks of the pages to files; how many there are."""
    count = 0
    for page in sorted(glob.glob(os.path.join(TOP, "docs", "rules", "*.md"))):
        name, file = os.path.splitext(os.path.basename(page))[0], None
        for line in open(page, encoding="utf-8"):
            if line.startswith("```"):
                kind, _, verdict = line[3:].strip().partition(",")
                if file:
                    file.close()
                file = None
                if verdict.partition(",")[0] == "bad" and kind in ("urdf", "xacro"):
                    count += 1
                    file = open(os.path.join(folder, f"{name}_{count}.{kind}"), "w", encoding="utf-8")
            elif file and line.startswith("//- "):
                path = os.path.join(folder, f"{name}_{count}", line[4:].strip())
                os.makedirs(os.path.dirname(path), exist_ok=True)
                file.close()
                file = open(path, "w", encoding="utf-8")
            elif file and not ("^" in line and set(line.strip()) <= {" ", "^"}):
                file.write(line)
    return count
