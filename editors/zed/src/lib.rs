//! Starts the language server `xacro-lsp` in Zed: the one of the settings, the one on the `PATH`, or that of the newest release.

use zed_extension_api::settings::LspSettings;
use zed_extension_api::{self as zed, Architecture, LanguageServerId, Os, Result};

/// Whose releases are taken.
const REPOSITORY: &str = "OWNER/REPOSITORY";
const NAME: &str = "xacro-lsp";

struct Xacro {
    /// The program that was downloaded in this session.
    downloaded: Option<String>,
}

impl zed::Extension for Xacro {
    fn new() -> Self {
        Xacro { downloaded: None }
    }

    fn language_server_command(
        &mut self,
        id: &LanguageServerId,
        worktree: &zed::Worktree,
    ) -> Result<zed::Command> {
        let binary = LspSettings::for_worktree(NAME, worktree).ok().and_then(|settings| settings.binary);
        let args = binary.as_ref().and_then(|binary| binary.arguments.clone()).unwrap_or_default();
        let chosen = binary.and_then(|binary| binary.path).or_else(|| worktree.which(NAME));
        let command = match chosen {
            Some(path) => path,
            None => self.download(id)?,
        };
        Ok(zed::Command { command, args, env: worktree.shell_env() })
    }
}

impl Xacro {
    /// The server of the newest release, which is downloaded once.
    fn download(&mut self, id: &LanguageServerId) -> Result<String> {
        if let Some(path) = &self.downloaded {
            return Ok(path.clone());
        }
        let options = zed::GithubReleaseOptions { require_assets: true, pre_release: false };
        let release = zed::latest_github_release(REPOSITORY, options)?;
        let (target, exe) = target()?;
        let archive = format!("xacro-lint-{target}.tar.gz");
        let asset = release.assets.iter().find(|asset| asset.name == archive);
        let asset = asset.ok_or_else(|| format!("release {} has no `{archive}`", release.version))?;
        let folder = format!("xacro-lint-{}", release.version);
        // the server starts the `xacro-lint` in its own folder
        let programs = [NAME, "xacro-lint"].map(|name| format!("{folder}/xacro-lint-{target}/{name}{exe}"));
        if !programs.iter().all(|path| std::fs::metadata(path).is_ok_and(|found| found.is_file())) {
            let status = zed::LanguageServerInstallationStatus::Downloading;
            zed::set_language_server_installation_status(id, &status);
            zed::download_file(&asset.download_url, &folder, zed::DownloadedFileType::GzipTar)?;
            for path in &programs {
                zed::make_file_executable(path)?;
            }
        }
        let [server, _] = programs;
        self.downloaded = Some(server.clone());
        Ok(server)
    }
}

/// What releases call this platform, and how programs end there.
fn target() -> Result<(&'static str, &'static str)> {
    match zed::current_platform() {
        (Os::Linux, Architecture::X8664) => Ok(("x86_64-unknown-linux-gnu", "")),
        (Os::Linux, Architecture::Aarch64) => Ok(("aarch64-unknown-linux-gnu", "")),
        (Os::Mac, Architecture::X8664) => Ok(("x86_64-apple-darwin", "")),
        (Os::Mac, Architecture::Aarch64) => Ok(("aarch64-apple-darwin", "")),
        (Os::Windows, Architecture::X8664) => Ok(("x86_64-pc-windows-msvc", ".exe")),
        _ => Err("there is no release for this platform; set `lsp.xacro-lsp.binary.path`".to_owned()),
    }
}

zed::register_extension!(Xacro);
