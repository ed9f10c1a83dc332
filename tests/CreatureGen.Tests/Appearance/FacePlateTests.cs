using CreatureGen.Appearance;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class FacePlateTests
{
    /// <summary>A round plate was a disc from ahead.</summary>
    [Fact]
    public void The_plate_over_the_jaws_of_an_insect_is_a_shield_with_corners_and_broader_below()
    {
        float lower = BreadthAt(2.4f);
        float middle = BreadthAt(3.6f);
        float upper = BreadthAt(5f);
        Assert.True(lower > middle && middle > upper, $"{lower} {middle} {upper}");
        Assert.True(upper > 0.55f * lower, $"{upper} of {lower} above: an ellipse runs out to a point");
    }

    [Fact]
    public void A_seam_parts_the_shield_from_the_lip_and_another_goes_up_the_forehead_and_forks()
    {
        Assert.True(FacePlate.At(1.45f, 0).Seam > 0.7f);
        Assert.Equal(1f, FacePlate.At(7f, 0).Seam, 0.01f);
        Assert.Equal(0f, FacePlate.At(7f, 0.3f).Seam);
        Assert.Equal(0f, FacePlate.At(11f, 0).Seam);
        Assert.True(FacePlate.At(11f, 0.75f * 2.8f / 3.8f).Seam > 0.9f);
        Assert.Equal((0f, 0f), FacePlate.At(13f, 0));
    }

    private static float BreadthAt(float ring)
    {
        float around = 0;
        while (FacePlate.At(ring, around).Plate > 0.5f)
        {
            around += 0.01f;
        }

        return around;
    }
}
