//! `xacro-lint preview`: the robot in a browser, following the files on the disk.

use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

use serde_json::json;

use super::args::PreviewArgs;
use super::io::Io;
use super::render::{shown_path, visible};
use super::tree::file_and_arguments;
use super::watch::WatchedFiles;
use analysis::{AnalysisHost, RootConfig};
use base::paths::HERE;
use base::{CancelFlag, Encoding};
use packages::percent_decoded;
use preview::{FromViewer, Hub, Location, LocationFormat, Received, RootName, Views, file_uri};
use vfs::Environment;

/// Between two looks at the files of the robot; looking takes no more than one part in `SHARE` of the time.
const LOOK: Duration = Duration::from_millis(30);
const SHARE: u32 = 40;
/// Between two looks at everything else: packages that came, patterns that match more, pages that were opened.
const LOOK_AROUND: Duration = Duration::from_millis(250);

/// Run `preview`; it ends with the process.
pub(super) fn run(args: &PreviewArgs, env: &Environment, io: &mut Io<'_>) -> u8 {
    match open(args, env) {
        Ok(preview) => preview.run(env, io),
        Err(message) => {
            io.line(&format!("error: {}", visible(&message)));
            2
        }
    }
}

struct Preview {
    host: AnalysisHost,
    views: Views,
    hub: std::sync::Arc<Hub>,
    said: Receiver<Received>,
    id: u32,
}

fn open(args: &PreviewArgs, env: &Environment) -> Result<Preview, String> {
    let (file, arguments) = file_and_arguments(&args.file)?;
    let mut host = AnalysisHost::new(env.clone(), Vec::new());
    if !args.package_path.is_empty() {
        host.set_editor_settings(json!({ "packagePaths": args.package_path }));
    }
    let vfs = host.session().vfs.clone();
    let path = vfs.absolute(Path::new(&file));
    if !vfs.is_file(&path) {
        return Err(format!("{file}: no such file"));
    }
    if !preview::HAS_VIEWER {
        return Err(
            "this program was built without the viewer; run `npm ci` and `npm run build` in editors/viewer, \
                    build the program again, or install a release"
                .to_owned(),
        );
    }
    let mut views = Views::default();
    let id = views.open(RootConfig {
        args: arguments,
        ..RootConfig::plain(&path)
    });
    let (say, said) = mpsc::channel();
    // the other end is gone only when the process ends
    let receive = move |received| drop(say.send(received));
    let hub = Hub::start(views.files().clone(), vfs, receive)
        .map_err(|error| format!("cannot start the preview: {error}"))?;
    hub.open(id);
    Ok(Preview {
        host,
        views,
        hub,
        said,
        id,
    })
}

impl Preview {
    fn run(mut self, env: &Environment, io: &mut Io<'_>) -> u8 {
        io.out(&format!("{}\n", self.hub.url(self.id)));
        io.line("open this address in a browser; press Ctrl-C to stop");
        io.flush();
        let mut state = WatchedFiles::new();
        let mut around = Instant::now();
        self.follow(&mut state, WatchedFiles::new());
        loop {
            let begin = Instant::now();
            let now = self.state();
            let pause = LOOK.max(begin.elapsed() * SHARE);
            if now != state || around.elapsed() >= LOOK_AROUND {
                self.follow(&mut state, now);
                around = Instant::now();
            }
            match self.said.recv_timeout(pause) {
                Ok(received) => {
                    self.answer(received, env, io);
                    // what is to be shown may be another robot now
                    around = begin.checked_sub(LOOK_AROUND).unwrap_or(begin);
                }
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => return 0,
            }
        }
    }

    /// Send what became of changed files: those that are `now` not as they were in `state`.
    fn follow(&mut self, state: &mut WatchedFiles, now: WatchedFiles) {
        let differs =
            |(path, one): &(&PathBuf, &u64)| state.get(*path).is_some_and(|known| known != *one);
        let changed: Vec<PathBuf> = now
            .iter()
            .filter(differs)
            .map(|(path, _)| path.clone())
            .collect();
        if !changed.is_empty() {
            self.host.changed_on_disk(&changed);
        }
        let Self {
            host, views, hub, ..
        } = self;
        let watched = |id| hub.is_watched(id);
        let (messages, _) =
            with_names(|names| views.update(host, names, &watched, &CancelFlag::default()));
        messages.iter().for_each(|message| hub.tell(message));
        // what changed while it was read counts as not seen yet
        *state = self.state();
        now.into_iter()
            .for_each(|(path, one)| drop(state.entry(path).and_modify(|known| *known = one)));
    }

    fn state(&self) -> WatchedFiles {
        let vfs = &self.host.session().vfs;
        self.views
            .reads()
            .into_iter()
            .map(|path| (path.clone(), vfs.state_on_disk(&path)))
            .collect()
    }

    fn answer(&mut self, received: Received, env: &Environment, io: &mut Io<'_>) {
        let Received { id, message } = received;
        match message {
            FromViewer::Ready | FromViewer::Mesh { .. } => {}
            FromViewer::Select {
                link,
                joint,
                location,
            } => {
                let found = with_names(|names| self.views.place_of(id, link, joint, names));
                let Some(selection) = found else { return };
                self.hub.select(&selection);
                if let Some(location) = location.or(selection.location) {
                    say_place(&location, env, io);
                }
            }
            FromViewer::Open { location } => say_place(&location, env, io),
            FromViewer::Root { root, compare } => {
                let Some(root) = self.chosen(root) else {
                    return;
                };
                let compare = compare.and_then(|compare| self.chosen(compare));
                if compare.is_none() {
                    self.hub.end_compare(id);
                }
                self.views.show(id, root, compare);
            }
        }
    }

    /// A root that a page names: one that was offered, with any arguments.
    fn chosen(&self, name: RootName) -> Option<RootConfig> {
        let file = path_of(&name.uri)?;
        let offered = self
            .views
            .root(self.id)
            .is_some_and(|root| root.file == file)
            || self.host.known_files().contains(&file);
        let args = name.args.into_iter().collect();
        offered.then_some(RootConfig {
            file,
            args,
            preset: name.preset,
        })
    }
}

/// Print the place of what was clicked, so that a terminal or an editor around it can go there.
fn say_place(location: &Location, env: &Environment, io: &mut Io<'_>) {
    let Some(path) = path_of(&location.uri) else {
        return;
    };
    let start = location.range.start;
    let place = format!(
        "{}:{}:{}",
        shown_path(&path, &env.cwd),
        start.line + 1,
        start.character + 1
    );
    io.line(&visible(&place));
    io.flush();
}

fn with_names<T>(work: impl FnOnce(&LocationFormat<'_>) -> T) -> T {
    let uri = |path: &Path| Some(file_uri(path));
    work(&LocationFormat {
        uri: &uri,
        path: &path_of,
        encoding: Encoding::Utf32,
    })
}

fn path_of(uri: &str) -> Option<PathBuf> {
    let path = HERE.of_file_uri(uri.strip_prefix("file:")?)?;
    Some(PathBuf::from(percent_decoded(&path).unwrap_or(path)))
}
