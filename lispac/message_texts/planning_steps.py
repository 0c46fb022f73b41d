"""Texts of messages about survey plans, simulations and clusters of computers."""

from collections.abc import Mapping

from lispac.language import N_, Plural, Template

TEXTS: Mapping[str, Template] = {
    # -- cluster -------------------------------------------------------------------------------
    # Only a command uses a cluster, so these texts may name commands of Dask.
    "cluster.not_installed": N_(
        "Simulation campaigns on several computers need the Python package distributed. Run python "
        "-m pip install -e '.[cluster]' in the checkout, on this computer and on the workers."
    ),
    "cluster.no_scheduler": N_(
        "{address}: no scheduler answered within {limit:s.0} s. Start one with `dask "
        "scheduler`, and check the address that it prints and the firewall."
    ),
    "cluster.no_workers": N_(
        "{address}: the scheduler has no workers. Start one on each computer with `dask worker "
        "{address} --nworkers auto --nthreads 1`."
    ),
    "cluster.scheduler_version": N_(
        "The scheduler {address} runs LISPAC {version}, but this computer runs {expected}. "
        "Install the same version on all computers."
    ),
    "cluster.scheduler_without_version": N_(
        "The scheduler {address} did not report its version of LISPAC ({reason}). Install "
        "LISPAC {expected} there, as on this computer."
    ),
    "cluster.worker_version": N_(
        "The worker {address} runs LISPAC {version}, but this computer runs {expected}. Install "
        "the same version on all computers."
    ),
    "cluster.worker_without_version": N_(
        "The worker {address} did not report its version of LISPAC ({reason}). Install LISPAC "
        "{expected} there, as on this computer."
    ),
    "cluster.late_worker_version": N_(
        "A worker that joined during the campaign runs LISPAC {version}, but the campaign was "
        "started with {expected}. Install the same version on all computers."
    ),
    "cluster.worker_lost_repeatedly": Plural(
        "{address}: one calculation terminated its worker {times:n} times, for lack of memory or "
        "because another program stopped it. Start the campaign with fewer processes.",
        "{address}: the same {count:n} calculations terminated their worker {times:n} times, for "
        "lack of memory or because another program stopped it. Start the campaign with fewer "
        "processes.",
    ),
    "cluster.no_workers_left": N_(
        "{address}: all workers have stopped. Start them and the campaign again."
    ),
    "cluster.connection_lost": N_(
        "{address}: the connection to the scheduler or its workers was lost. Start the campaign "
        "again."
    ),
    "cluster.bad_address": N_(
        "{address} is not the address of a scheduler. Write it as tls://HOST:PORT, for example "
        "tls://192.168.1.20:8786."
    ),
    "cluster.plain_tcp_refused": N_(
        "{address}: TCP is neither encrypted nor authenticated, so other users of the network "
        "could run programs on this computer and on the workers. Use TLS certificates and tls://, "
        "or accept the risk."
    ),
    "cluster.no_certificates": N_(
        "{address}: TLS needs certificates. Give the files of the authority, the certificate and "
        "the key, here or in the configuration of Dask."
    ),
    "cluster.unusable_certificates": N_(
        "{address}: the TLS certificates cannot be used ({reason}). Check the files of the "
        "authority, the certificate and the key."
    ),
    # -- plan_survey ---------------------------------------------------------------------------
    "plan_survey.process_ended": N_(
        "A process of this calculation was terminated by the system, perhaps for lack of memory. "
        "Close other programs or use fewer processes, and start again."
    ),
    "plan_survey.one_orientation": N_(
        "All targets have the same orientation, which the adjustment does not accept. Add a target "
        "with a different inclination."
    ),
    "plan_survey.folder_not_created": N_(
        "{folder}: this folder cannot be created ({reason}). Choose another folder."
    ),
    "plan_survey.no_target_measured": N_(
        "{project} contains no target of this survey plan. Rename its targets as in the plan "
        "({targets:names}), or choose another project."
    ),
    "plan_survey.no_line_measured": N_(
        "{project} contains no line of this survey plan: targets are matched by name "
        "({targets:names}), lines by heading. Choose another project or another plan."
    ),
    "plan_survey.line_not_surveyed": N_(
        "Line {line:n} (heading {heading:deg.0}°) was not surveyed."
    ),
    "plan_survey.target_not_used": N_("Target {target} was not used."),
    "plan_survey.control_not_used": N_(
        "The planned control on {targets:names} was not used in the adjustment."
    ),
    "plan_survey.control_gain": N_(
        "The prediction uses surveyed control on {targets:names}. Without it, the standard "
        "deviations would be {roll:deg.4}° in roll, {pitch:deg.4}° in pitch and {yaw:deg.4}° in "
        "yaw."
    ),
    "plan_survey.control_needed": N_(
        "The prediction uses surveyed control on {targets:names}. Without it, the boresight angles "
        "would not be determined."
    ),
    "plan_survey.other_distance": N_(
        "Line {line:n} (heading {heading:deg.0}°) was surveyed at {distance:m.0} m instead of "
        "{planned:m.0} m."
    ),
    "plan_survey.would_be_determined": N_(
        "{missing} With it the boresight angles would be determined."
    ),
    "plan_survey.smaller_sigma": N_(
        "{missing} With it the standard deviation of {angle} would be {sigma:deg.4}° instead of "
        "{without:deg.4}°."
    ),
    # -- campaign ------------------------------------------------------------------------------
    "campaign.sigma_too_small": N_(
        "The standard deviation of {angle} from the adjustment is too small: its 95 % interval "
        "contains the truth in {share:percent.0} % of the surveys. Add targets or lines, or allow "
        "for larger errors."
    ),
    "campaign.coverage_agrees": N_(
        "The coverage of the 95 % intervals agrees with 95 %, within the accuracy that {count:n} "
        "surveys allow."
    ),
    "campaign.mean_error": N_(
        "The mean error of {angle} is significant: {mean:deg.4+}°. Add targets or lines, or "
        "allow for this error."
    ),
    "campaign.errors_agree": N_(
        "Chi-square {value:x.0}, expected {low:x.0} to {high:x.0}: the errors agree with the "
        "prediction."
    ),
    "campaign.errors_larger": N_(
        "Chi-square {value:x.0}, expected {low:x.0} to {high:x.0}: the errors are larger than "
        "predicted. Add targets or lines, or allow for larger errors."
    ),
    "campaign.errors_smaller": N_(
        "Chi-square {value:x.0}, expected {low:x.0} to {high:x.0}: the errors are smaller than "
        "predicted."
    ),
    "campaign.not_adjusted": Plural(
        "{count:n} survey could not be adjusted and is excluded.",
        "{count:n} surveys could not be adjusted and are excluded.",
    ),
    # -- simulate ------------------------------------------------------------------------------
    "simulate.line_without_points": N_(
        "No surface of the scene is visible from line {line}. Move its course closer, or widen the "
        "angular window of the scanner."
    ),
    "simulate.folder_is_file": N_(
        "{folder} is a file, not a folder. Choose a folder for the simulated survey."
    ),
    "simulate.folder_in_use": N_(
        "{folder}: this folder contains other files. Choose a new folder."
    ),
    "simulate.no_scene": N_(
        "There is no scene named {name}. Give one of {known:names}, or a file that ends in .toml."
    ),
    "simulate.no_vessel": N_(
        "There is no vessel named {name}. Give one of {known:names}, or a file that ends in .toml."
    ),
    "simulate.no_scanner": N_(
        "There is no scanner named {name}. Give one of {known:names}, or a file that ends in .toml."
    ),
    "simulate.no_trajectory": N_(
        "{file}: the lines are defined by start_s, so a recorded trajectory is needed. Give it, "
        "or enter it as trajectory in the scene file."
    ),
    "simulate.no_origin": N_(
        "{file}: the table [origin] is missing. Add it with the position of the scene."
    ),
    "simulate.too_long": N_(
        "{file}: with {vessel} the survey takes {duration:h.0} h, but at most {limit:h.0} h can be "
        "simulated. Correct run_in_m and run_out_m, or speed_m_s, transit_s and wait_s of the "
        "vessel."
    ),
    "simulate.lines_by_heading": N_(
        "{file}: the lines are defined by headings, so the recorded trajectory {trajectory} cannot "
        "be used. Define each of the [[lines]] by start_s, stop_s and side, in the time of the "
        "trajectory."
    ),
    "simulate.origin_too_far": N_(
        "{file}: the origin of the scene is {distance:km} km from {trajectory}. Correct [origin], "
        "or omit it to use the mean position of the trajectory."
    ),
}
