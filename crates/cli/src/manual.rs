//! `tribodyn completions` and `tribodyn man`: what shells and `man` know of the command.

use crate::failure::Failure;
use crate::input::ReplaceArguments;
use clap_mangen::Man;
use std::io::Write;
use std::path::PathBuf;
use tribodyn_study::StagedFiles;

/// Print a script by which a shell completes the command's words.
#[derive(clap::Args)]
#[command(after_help = "Examples:
  tribodyn completions bash > ~/.local/share/bash-completion/completions/tribodyn
  tribodyn completions fish > ~/.config/fish/completions/tribodyn.fish")]
pub struct CompletionArguments {
    /// The shell
    #[arg(value_enum)]
    shell: clap_complete::Shell,
}

/// Write the manual pages of the command and of all its parts.
#[derive(clap::Args)]
pub struct ManArguments {
    /// Folder for tribodyn.1, tribodyn-solve.1 and the others
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    #[command(flatten)]
    replace: ReplaceArguments,
}

pub fn completions(arguments: &CompletionArguments, mut command: clap::Command) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "tribodyn", &mut script);
    std::io::stdout().write_all(&script).map_err(Failure::Output)
}

pub fn man(arguments: &ManArguments, mut command: clap::Command) -> Result<(), Failure> {
    // Gives all parts their full names.
    command.build();
    let mut staged = StagedFiles::new(&arguments.output, arguments.replace.force)?;
    pages(&mut staged, &command)?;
    Ok(staged.publish()?)
}

/// The page of a command and those of its parts.
fn pages(staged: &mut StagedFiles, command: &clap::Command) -> Result<(), Failure> {
    let name = command.get_display_name().unwrap_or(command.get_name()).to_owned();
    let mut page = Vec::new();
    Man::new(command.clone()).render(&mut page).map_err(Failure::Output)?;
    staged.write(format!("{name}.1"), &page)?;
    let parts = command.get_subcommands().filter(|part| !part.is_hide_set() && part.get_name() != "help");
    parts.into_iter().try_for_each(|part| pages(staged, part))
}
