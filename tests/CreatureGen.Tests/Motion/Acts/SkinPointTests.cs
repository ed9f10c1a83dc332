using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Acts.Bodies;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class SkinPointTests
{
    [Fact]
    public void A_point_of_the_skin_is_where_skinning_has_it_in_any_pose()
    {
        var animator = new CreatureAnimator(new MotionProfile(Walkers.Any(4201)));
        Walkers.Run(animator, 1.3f, 60f, new MotionInput(0.8f, 0.4f), FlatGround.Level);
        Skeleton skeleton = animator.Profile.Subject.Skeleton;
        CreatureMesh mesh = animator.Profile.Subject.Mesh;
        var matrices = new Matrix4x4[skeleton.Count];
        var positions = new Vector3[mesh.Positions.Length];
        SkinMatrices.Fill(skeleton, animator.ModelPose, matrices);
        CpuSkinning.Skin(matrices, mesh.Weights, mesh.Positions, mesh.Normals, positions, new Vector3[positions.Length]);
        for (int v = 0; v < positions.Length; v += 7)
        {
            var point = new SkinPoint(skeleton, mesh.Positions[v], mesh.Weights[v]);
            Assert.InRange(Vec.Distance(point.PlaceIn(animator.ModelPose), positions[v]), 0f, 1e-4f);
        }
    }
}
