using CreatureGen.Appearance;
using CreatureGen.Maths;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class GillMarkTests
{
    /// <summary>Markings of the trunk behind this ring are painted no finer than the mesh: a line is lost there.</summary>
    private const float LastRingOfHead = 16f;

    [Fact]
    public void A_fish_has_a_dark_line_behind_its_cheek_that_ends_on_its_back_and_its_throat()
    {
        Assert.True(Darkest(GillMark.Cover, 1.75f) > 0.9f);
        Assert.Equal(0f, Darkest(GillMark.Cover, 0.5f));
        Assert.Equal(0f, Darkest(GillMark.Cover, 3f));
        Assert.Equal(0f, Darkest(GillMark.None, 1.75f));
    }

    [Theory]
    [InlineData(1.7f, true)]
    [InlineData(0.66f, false)]
    [InlineData((float)PortableMath.Pi - 0.66f, false)]
    public void Sharks_have_five_slits_on_the_flank_and_rays_above_and_below(float around, bool shark)
    {
        GillMark mark = shark ? GillMark.Slits : GillMark.DiscSlits;
        int slits = 0;
        bool dark = false;
        for (float ring = 5f; ring < LastRingOfHead; ring += 0.02f)
        {
            bool here = GillMarks.At(mark, ring, around) > 0.5f;
            slits += here && !dark ? 1 : 0;
            dark = here;
        }

        Assert.Equal(5, slits);
        Assert.False(dark);
        Assert.Equal(0f, Darkest(mark, 0f));
    }

    private static float Darkest(GillMark mark, float around)
    {
        float darkest = 0f;
        for (float ring = 0f; ring < LastRingOfHead; ring += 0.02f)
        {
            darkest = System.Math.Max(darkest, GillMarks.At(mark, ring, around));
        }

        return darkest;
    }
}
