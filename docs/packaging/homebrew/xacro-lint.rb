class XacroLint < Formula
  desc "Linter and language server for xacro and URDF robot descriptions"
  homepage "https://github.com/@OWNER@/@REPOSITORY@"
  version "@VERSION@"
  license any_of: ["MIT", "Apache-2.0"]

  on_macos do
    on_arm do
      url "https://github.com/@OWNER@/@REPOSITORY@/releases/download/v@VERSION@/xacro-lint-aarch64-apple-darwin.tar.gz"
      sha256 "@SHA256:xacro-lint-aarch64-apple-darwin.tar.gz@"
    end
    on_intel do
      url "https://github.com/@OWNER@/@REPOSITORY@/releases/download/v@VERSION@/xacro-lint-x86_64-apple-darwin.tar.gz"
      sha256 "@SHA256:xacro-lint-x86_64-apple-darwin.tar.gz@"
    end
  end

  on_linux do
    on_arm do
      url "https://github.com/@OWNER@/@REPOSITORY@/releases/download/v@VERSION@/xacro-lint-aarch64-unknown-linux-gnu.tar.gz"
      sha256 "@SHA256:xacro-lint-aarch64-unknown-linux-gnu.tar.gz@"
    end
    on_intel do
      url "https://github.com/@OWNER@/@REPOSITORY@/releases/download/v@VERSION@/xacro-lint-x86_64-unknown-linux-gnu.tar.gz"
      sha256 "@SHA256:xacro-lint-x86_64-unknown-linux-gnu.tar.gz@"
    end
  end

  def install
    bin.install "xacro-lint", "xacro-lsp"
    generate_completions_from_executable(bin/"xacro-lint", "completions")
  end

  test do
    (testpath/"robot.urdf").write <<~XML
      <robot name="r"><link name="a"/><link name="b"/></robot>
    XML
    assert_match "orphan-link", shell_output("#{bin}/xacro-lint check --format concise robot.urdf", 1)
  end
end
