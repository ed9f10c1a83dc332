using Xunit;

namespace CreatureGen.Lab.Tests;

/// <summary>Claims about the page; <c>samples/CreatureGen.Lab/page/tests/check.mjs</c> checks them in a browser.</summary>
public sealed class PageTests(PageFixture page) : IClassFixture<PageFixture>
{
    [Fact]
    public void Files_that_the_page_makes_are_the_native_ones_for_twelve_seeds_of_each_kind() => page.Holds("files equal native ones");

    [Fact]
    public void A_creature_walks_where_it_is_sent() => page.Holds("it walks where it is sent");

    [Fact]
    public void Neighbours_come() => page.Holds("neighbours come, and are counted");

    [Fact]
    public void Sliders_make_valid_creatures_at_both_ends() => page.Holds("sliders make valid creatures at both ends");

    [Fact]
    public void Arms_have_a_slider_of_their_own_at_both_ends_sound() => page.Holds("arms have a slider of their own, at both ends sound");

    [Fact]
    public void A_slider_changes_the_creature_and_its_address_and_undo_takes_it_back() => page.Holds("a slider changes the creature and its address, and undo takes it back");

    [Fact]
    public void Repair_is_told_with_its_reason() => page.Holds("repair is told with its reason");

    [Fact]
    public void A_lock_keeps_a_trait() => page.Holds("a lock keeps a trait");

    [Fact]
    public void Two_creatures_have_a_litter_of_nine_and_a_child_grows_up() => page.Holds("two creatures have a litter of nine, and a child grows up");

    [Fact]
    public void Two_parents_stand_side_by_side_where_one_breeds_and_part_where_one_does_not() => page.Holds("two parents stand side by side where one breeds, and part where one does not");

    [Fact]
    public void A_baked_creature_moves_while_the_library_starts_then_the_live_one_comes() => page.Holds("a baked creature moves while the library starts, then the live one comes");

    [Fact]
    public void Where_less_motion_is_asked_for_only_creatures_move() => page.Holds("where less motion is asked for, only creatures move");

    [Fact]
    public void Everything_is_done_by_keys_alone() => page.Holds("everything is done by keys alone");

    [Fact]
    public void Trunk_neck_tail_and_legs_are_pulled_by_the_part_that_is_under_the_pointer() => page.Holds("trunk, neck, tail and legs are pulled by the part that is under the pointer");

    [Fact]
    public void The_page_answers_while_the_library_grows_creatures() => page.Holds("the page answers while the library grows creatures");

    [Fact]
    public void A_creature_is_seen_in_each_of_its_looks_with_its_feet_and_its_gait() => page.Holds("a creature is seen in each of its looks, with its feet and its gait");

    [Fact]
    public void The_address_of_a_child_brings_it_back() => page.Holds("a child’s address brings it back");

    [Fact]
    public void A_picture_gives_its_creature_back() => page.Holds("a picture gives its creature back");

    [Fact]
    public void Bad_files_seeds_and_addresses_are_told_and_the_page_lives_on() => page.Holds("bad files, seeds and addresses are told, and the page lives on");

    [Fact]
    public void Names_bring_no_markup() => page.Holds("names bring no markup");

    [Fact]
    public void Creatures_come_and_go_and_the_memory_stays_as_it_was() => page.Holds("creatures come and go, and the memory stays as it was");

    [Fact]
    public void Sounds_begin_and_end_without_a_click_do_not_clip_and_are_deeper_the_heavier_who_makes_them() =>
        page.Holds("sounds begin and end without a click, do not clip, and are deeper the heavier who makes them");

    [Fact]
    public void The_grid_shows_creatures_that_live_by_kind_of_one_species_and_of_one_family() => page.Holds("the grid shows creatures that live: by kind, of one species, of one family");

    [Fact]
    public void The_grid_holds_to_its_filters_tells_what_cannot_be_grown_and_stops_when_it_is_closed() =>
        page.Holds("the grid holds to its filters, tells what cannot be grown, and stops when it is closed");

    [Fact]
    public void The_sliders_and_parts_that_the_page_shows_before_the_library_runs_are_the_librarys_own() => page.Holds("the sliders and parts that the page shows before the library runs are the library's own");

    [Fact]
    public void Surprises_and_nudges_are_sound_and_undo_and_redo_go_back_and_forth_between_them() => page.Holds("surprises and nudges are sound, and undo and redo go back and forth between them");

    [Fact]
    public void A_finger_turns_the_eye_and_pulls_on_the_body_two_zoom() => page.Holds("a finger turns the eye and pulls on the body, two zoom");

    [Fact]
    public void Nothing_is_heard_until_somebody_asks_for_it() => page.Holds("nothing is heard until somebody asks for it");

    [Fact]
    public void Addresses_have_two_thousand_letters_at_most_read_and_written() => page.Holds("addresses have two thousand letters at most, read and written");

    [Fact]
    public void It_begins_as_strange_as_the_library_does() => page.Holds("it begins as strange as the library’s own default");

    [Fact]
    public void Feet_stay_where_they_stand() => page.Holds("feet stay where they stand");

    [Fact]
    public void It_staggers_when_it_is_pushed_falls_when_it_is_pushed_hard_and_gets_up() => page.Holds("it staggers when it is pushed, falls when it is pushed hard, and gets up");

    [Fact]
    public void It_is_petted_dances_and_comes_for_its_fruit() => page.Holds("it is petted, dances, and comes for its fruit");

    [Fact]
    public void Pulling_on_the_body_changes_it_and_escape_takes_it_back() => page.Holds("pulling on the body changes it, and Escape takes it back");

    [Fact]
    public void Parts_are_put_on_and_taken_off() => page.Holds("parts are put on and taken off");

    [Fact]
    public void All_changed_sliders_of_the_longest_seed_fit_into_eighty_letters() => page.Holds("all changed sliders of the longest seed fit into eighty letters");

    [Fact]
    public void A_family_can_be_walked_back_and_branches() => page.Holds("a family can be walked back, and branches");

    [Fact]
    public void A_population_is_bred_on_towards_a_goal_while_one_looks_on() => page.Holds("a population is bred on towards a goal while one looks on");

    [Fact]
    public void Its_gait_comes_as_an_animated_picture_that_holds_its_blueprint() => page.Holds("its gait comes as an animated picture that holds its blueprint");

    [Fact]
    public void A_collection_is_taken_along_and_what_is_none_is_refused() => page.Holds("a collection is taken along, and what is none is refused");

    [Fact]
    public void Twenty_creatures_live_for_a_minute_and_memory_stays() => page.Holds("twenty creatures live for a minute, and memory stays");

    [Fact]
    public void The_page_works_without_a_network_after_the_first_visit() => page.Holds("the page works without a network after the first visit");

    [Fact]
    public void A_browser_that_cannot_run_it_gets_pictures() => page.Holds("a browser that cannot run it gets pictures");

    [Fact]
    public void While_an_act_is_tried_others_live_on() => page.Holds("while an act is tried others live on");

    [Fact]
    public void Axe_finds_no_serious_issue_on_any_tab() => page.Holds("axe finds no serious issue on any tab");

    [Fact]
    public void An_exported_page_works_below_a_path_of_a_plain_host() => page.Holds("an exported page works below a path of a plain host");

    [Fact]
    public void The_page_looks_as_it_did() => page.Holds("lab.png is what is seen");

    [Fact]
    public void The_page_looks_as_it_did_on_a_phone() => page.Holds("lab-phone.png is what is seen");

    [Fact]
    public void The_pointer_pets_sends_calls_pushes_turns_and_zooms() => page.Holds("the pointer pets, sends, calls, pushes, turns and zooms");

    [Fact]
    public void The_creature_of_the_day_is_that_of_the_date() => page.Holds("the creature of the day is that of the date");

    [Fact]
    public void Files_are_downloaded_whole() => page.Holds("files are downloaded whole: blueprint, plain GLB, GLB with textures and clips");

    [Fact]
    public void Nothing_leaves_the_machine() => page.Holds("nothing leaves the machine");

    [Fact]
    public void The_browser_has_nothing_to_complain_of() => page.Holds("the console stays silent");
}
