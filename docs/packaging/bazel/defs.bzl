"""A test that checks robot descriptions.

Its result depends on the files in `srcs` and `deps` alone, so it is cached and shared like any other test.
"""

def _is_package(file):
    return file.basename == "package.xml"

def _quoted(text):
    return "'" + text.replace("'", "'\\''") + "'"

def _xacro_lint_test_impl(ctx):
    linter = ctx.executable.linter
    files = depset(ctx.files.srcs + ctx.files.config, transitive = [dep[DefaultInfo].files for dep in ctx.attr.deps])
    command = [linter.short_path, "check", "--format", "concise", "--require-packages"]

    # packages are looked for where their package.xml is, not in an installed ROS
    for file in files.to_list():
        if _is_package(file):
            command += ["--package-path", file.dirname or "."]
    if ctx.file.config:
        command += ["--config", ctx.file.config.short_path]
    command += ctx.attr.args_of_check
    command += [file.short_path for file in ctx.files.srcs]

    script = ctx.actions.declare_file(ctx.label.name + ".sh")
    ctx.actions.write(
        output = script,
        content = "#!/bin/sh\nexport AMENT_PREFIX_PATH= ROS_PACKAGE_PATH=\nexec " + " ".join([_quoted(part) for part in command]) + "\n",
        is_executable = True,
    )
    runfiles = ctx.runfiles(files = [linter], transitive_files = files)
    return [DefaultInfo(executable = script, runfiles = runfiles.merge(ctx.attr.linter[DefaultInfo].default_runfiles))]

xacro_lint_test = rule(
    implementation = _xacro_lint_test_impl,
    test = True,
    attrs = {
        "args_of_check": attr.string_list(doc = "Further options of `xacro-lint check`, and arguments as name:=value."),
        "config": attr.label(allow_single_file = [".toml"], doc = "The xacro-lint.toml; without it, that of the nearest folder."),
        "deps": attr.label_list(allow_files = True, doc = "What the robots read: included files, meshes, package.xml."),
        "linter": attr.label(default = "@xacro_lint//:xacro-lint", executable = True, cfg = "exec", allow_single_file = True),
        "srcs": attr.label_list(allow_files = [".xacro", ".urdf", ".xml"], mandatory = True, doc = "The robots."),
    },
    doc = "Checks robot descriptions with xacro-lint.",
)
