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
    public void A_slider_changes_the_creature_and_its_address_and_undo_takes_it_back() => page.Holds("a slider changes the creature and its address, and undo takes it back");

    [Fact]
    public void Repair_is_told_with_its_reason() => page.Holds("repair is told with its reason");

    [Fact]
    public void A_lock_keeps_a_trait() => page.Holds("a lock keeps a trait");

    [Fact]
    public void Two_creatures_have_a_litter_of_nine_and_a_child_grows_up() => page.Holds("two creatures have a litter of nine, and a child grows up");

    [Fact]
    public void The_address_of_a_child_brings_it_back() => page.Holds("a child’s address brings it back");

    [Fact]
    public void A_picture_gives_its_creature_back() => page.Holds("a picture gives its creature back");

    [Fact]
    public void Bad_files_seeds_and_addresses_are_told_and_the_page_lives_on() => page.Holds("bad files, seeds and addresses are told, and the page lives on");

    [Fact]
    public void Names_bring_no_markup() => page.Holds("names bring no markup");

    [Fact]
    public void Sixty_creatures_leave_the_memory_as_it_was() => page.Holds("sixty creatures leave the memory as it was");

    [Fact]
    public void The_grid_shows_creatures_that_live_by_kind() => page.Holds("the grid shows creatures that live, by kind");

    [Fact]
    public void Axe_finds_no_serious_issue_on_any_tab() => page.Holds("axe finds no serious issue on any tab");

    [Fact]
    public void An_exported_page_works_below_a_path_of_a_plain_host() => page.Holds("an exported page works below a path of a plain host");

    [Fact]
    public void The_page_looks_as_it_did() => page.Holds("lab.png is what is seen");

    [Fact]
    public void The_page_looks_as_it_did_on_a_phone() => page.Holds("lab-phone.png is what is seen");

    [Fact]
    public void The_browser_has_nothing_to_complain_of() => page.Holds("the console stays silent");
}
