using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Rigging;
using Xunit;

namespace CreatureGen.Tests.Skinning;

public sealed class ChainWeightsTests
{
    [Fact]
    public void Points_go_over_from_bone_to_bone_along_the_chain()
    {
        Skeleton skeleton = RigSubject.Of(BodyPlan.Eel).Skeleton;
        int[] chain = { skeleton.IndexOf("Spine_04"), skeleton.IndexOf("Spine_05"), skeleton.IndexOf("Spine_06"), skeleton.IndexOf("Spine_07") };
        Vector3 a = skeleton.ModelPositions[chain[0]];
        Vector3 b = skeleton.ModelPositions[chain[1]];
        Vector3 c = skeleton.ModelPositions[chain[2]];
        Vector3 end = skeleton.ModelPositions[chain[3]];
        Vector3 aside = Vector3.UnitX * 0.02f;
        SkinWeights[] w = ChainWeights.Solve(skeleton, chain, new[] { a + aside, b + aside, Vec.Lerp(b, c, 0.5f) - aside, end + aside, end + ((end - c) * 3f) });
        Assert.Equal(1f, w[0].Of(chain[0]));
        Assert.Equal(0.5f, w[1].Of(chain[0]), 1e-3f);
        Assert.Equal(0.5f, w[1].Of(chain[1]), 1e-3f);
        Assert.Equal(1f, w[2].Of(chain[1]));
        Assert.Equal(1f, w[3].Of(chain[2]));
        Assert.Equal(1f, w[4].Of(chain[2]));
        SkinFacts.AreWellFormed(w, skeleton);
        Assert.DoesNotContain(w, x => x.Influences().Any(i => i.Joint == chain[3]));
    }
}
