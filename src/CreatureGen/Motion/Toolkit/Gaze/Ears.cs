using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Gaze;

/// <summary>The ears of a skeleton, flicked back at their roots. Immutable.</summary>
internal sealed class Ears
{
    /// <summary>How far an ear is laid back and aside, radians.</summary>
    private const float Back = 0.55f;

    private const float Aside = 0.35f;

    private readonly Skeleton skeleton;
    private readonly int[] roots;

    private Ears(Skeleton skeleton, int[] roots)
    {
        this.skeleton = skeleton;
        this.roots = roots;
    }

    /// <summary>The ears of a skeleton but for those of heads other than one; null when it has none that move.</summary>
    public static Ears? Of(Skeleton skeleton, int head)
    {
        int[] roots = Array.FindAll(JointRelations.RootsOf(skeleton, JointRole.Ear), root => !Heads.IsOfAnother(skeleton, root, head));
        return roots.Length == 0 ? null : new Ears(skeleton, roots);
    }

    /// <summary>Flicks the ears. Nothing is allocated.</summary>
    /// <param name="act">How far.</param>
    /// <param name="local">Pose in the parents' space; the roots of ears are turned.</param>
    /// <param name="model">The same in model space, brought up to date.</param>
    public void Flick(in StandingAct act, in Pose local, in Pose model)
    {
        foreach (int root in roots)
        {
            Joint joint = skeleton.AllJoints[root];
            float flick = joint.Side == Side.Right ? act.RightEar : act.LeftEar;
            if (flick == 0f)
            {
                continue;
            }

            // Seen from the left ear; the right one's frame is its mirror image.
            float aside = joint.Side == Side.Right ? -Aside : Aside;
            Quaternion turn = Rotation.Multiply(Rotation.FromAxisAngle(Vector3.UnitZ, aside * flick), Rotation.FromAxisAngle(Vector3.UnitX, -Back * flick));
            local.Rotations[root] = Rotation.Multiply(local.Rotations[root], turn);
            Subtree.LocalToModel(skeleton, root, local, model);
        }
    }
}
