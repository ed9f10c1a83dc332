using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Animation.Grounds;
using CreatureGen.Animation.Ik;
using CreatureGen.Animation.Locomotion;
using CreatureGen.Animation.RootMotion;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Animation.Metrics;

/// <summary>Watches an animator and measures its motion: sliding, sinking and floating feet, clearance, joints beyond their limits, legs that fall short, jumps of the pose, feet on the ground.</summary>
/// <remarks>For tools and tests, not for frames of a game: it skins the feet in every frame.</remarks>
public sealed class MotionRecorder
{
    private const float LimitTolerance = 0.0017453f;
    private const float FlatFrom = 0.17f;
    private const float FlatTo = 0.58f;
    private const float SkatingShareOfSpeed = 0.1f;

    private readonly CreatureAnimator animator;
    private readonly Skeleton skeleton;
    private readonly LeggedBody body;
    private readonly FootSkin[] skins;
    private readonly Matrix4x4[] matrices;
    private readonly Quaternion[] before;
    private readonly Vector3?[] flatAt;
    private readonly Vector3[] lastMiddle;
    private readonly List<float> changes = new();
    private int frames;
    private double seconds;
    private float slip;
    private float lockDrift;
    private int flatFrames;
    private int skating;
    private float penetration;
    private double penetrationSum;
    private float floating;
    private float clearance = float.MaxValue;
    private float limitExcess;
    private int limitViolations;
    private int worstJoint = -1;
    private float stanceResidual;
    private float swingResidual;
    private int stanceFrames;
    private int stretched;
    private float fastest;
    private int leastSupport = int.MaxValue;
    private long support;
    private float lowest = float.MaxValue;
    private float highest = float.MinValue;

    /// <summary>Watches an animator of a creature that stands on legs.</summary>
    /// <exception cref="ArgumentException">The creature has no legs to stand on.</exception>
    public MotionRecorder(CreatureAnimator animator)
    {
        this.animator = animator ?? throw new ArgumentNullException(nameof(animator));
        body = animator.Profile.Legs ?? throw new ArgumentException("the creature has no legs to stand on; expected one that walks", nameof(animator));
        skeleton = body.Skeleton;
        matrices = new Matrix4x4[skeleton.Count];
        before = new Quaternion[skeleton.Count];
        skins = new FootSkin[body.Legs.Length];
        flatAt = new Vector3?[skins.Length];
        lastMiddle = new Vector3[skins.Length];
        for (int i = 0; i < skins.Length; i++)
        {
            skins[i] = new FootSkin(body.Creature, body.Legs[i].Ankle, body.Legs[i].Ball, body.Legs[i].Length);
        }
    }

    /// <summary>Measures the animator's pose after an update.</summary>
    /// <param name="dt">Seconds of that update.</param>
    /// <param name="ground">The ground it went on.</param>
    public void Record(float dt, IGround ground)
    {
        Pose model = animator.ModelPose;
        SkinMatrices.Fill(skeleton, model, matrices);
        MeasureJoints(dt);
        int down = 0;
        for (int i = 0; i < skins.Length; i++)
        {
            FootReport foot = animator.Foot(i);
            down += foot.Phase == FootPhase.Stance ? 1 : 0;
            MeasureFoot(i, foot, dt, ground, model);
        }

        frames++;
        seconds += dt;
        leastSupport = Math.Min(leastSupport, down);
        support += down;
        float pelvis = animator.Root.ToWorld(model.Positions[body.Trunk[0]]).Y / animator.Root.Scale;
        lowest = Math.Min(lowest, pelvis);
        highest = Math.Max(highest, pelvis);
    }

    /// <summary>What was measured so far.</summary>
    /// <exception cref="InvalidOperationException">Nothing was recorded.</exception>
    public MotionReport Report()
    {
        if (frames == 0)
        {
            throw new InvalidOperationException("nothing was recorded; expected at least one frame");
        }

        changes.Sort();
        float median = changes.Count == 0 ? 0f : changes[changes.Count / 2];
        float jump = changes.Count == 0 || median <= 0f ? 1f : changes[changes.Count - 1] / median;
        float length = body.LegLength;
        return new MotionReport(
            frames,
            (float)seconds,
            slip / length,
            lockDrift / length,
            flatFrames == 0 ? 0f : skating / (float)flatFrames,
            penetration / length,
            stanceFrames == 0 ? 0f : (float)(penetrationSum / stanceFrames / length),
            floating / length,
            clearance == float.MaxValue ? 0f : clearance / length,
            limitExcess,
            limitViolations,
            worstJoint,
            stanceResidual / length,
            swingResidual / length,
            stanceFrames == 0 ? 0f : stretched / (float)stanceFrames,
            fastest,
            jump,
            leastSupport,
            support / (float)frames,
            (highest - lowest) / length);
    }

    private void MeasureJoints(float dt)
    {
        double change = 0;
        ReadOnlySpan<Quaternion> rotations = animator.LocalPose.Rotations;
        for (int j = 0; j < skeleton.Count; j++)
        {
            Joint joint = skeleton.Joints[j];
            Quaternion turn = Rotation.Multiply(Rotation.Inverse(joint.LocalRotation), rotations[j]);
            if (joint.Role is not JointRole.Root and not JointRole.Body and not JointRole.End)
            {
                float excess = SwingTwistLimit.Excess(Rotation.Normalize(turn), joint.Limit);
                limitViolations += excess > LimitTolerance ? 1 : 0;
                if (excess > limitExcess)
                {
                    limitExcess = excess;
                    worstJoint = j;
                }
            }

            if (frames > 0 && dt > 0f)
            {
                float angle = (float)Rotation.Angle(Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(before[j]), rotations[j])));
                change += angle * angle;
                fastest = joint.Role is JointRole.Tail or JointRole.Ear or JointRole.Antenna ? fastest : Math.Max(fastest, angle / dt);
            }

            before[j] = rotations[j];
        }

        if (frames > 0 && dt > 0f)
        {
            changes.Add((float)Math.Sqrt(change) / dt);
        }
    }

    private void MeasureFoot(int index, in FootReport foot, float dt, IGround ground, in Pose model)
    {
        FootSkin skin = skins[index];
        RootPlace root = animator.Root;
        float least = float.MaxValue;
        for (int i = 0; i < skin.Count; i++)
        {
            Vector3 world = root.ToWorld(skin.At(i, matrices));
            least = Math.Min(least, HeightOver(world, ground) / root.Scale);
        }

        if (foot.Phase == FootPhase.Swing)
        {
            flatAt[index] = null;
            swingResidual = Math.Max(swingResidual, foot.Residual);
            if (skin.IsEmpty)
            {
                return;
            }

            penetration = Math.Max(penetration, -least);
            if (foot.Progress > 0.3f && foot.Progress < 0.75f)
            {
                clearance = Math.Min(clearance, least);
            }

            return;
        }

        stanceFrames++;
        stanceResidual = Math.Max(stanceResidual, foot.Residual);
        stretched += foot.Residual > 2e-3f * body.LegLength ? 1 : 0;
        if (skin.IsEmpty)
        {
            return;
        }

        penetration = Math.Max(penetration, -least);
        penetrationSum += Math.Max(-least, 0f);
        if (foot.Progress < FlatFrom || foot.Progress > FlatTo)
        {
            flatAt[index] = null;
            return;
        }

        floating = Math.Max(floating, least);
        Vector3 middle = root.ToWorld(skin.Middle(matrices)) / root.Scale;
        Vector3 place = foot.Place / root.Scale;
        Vector3 ball = root.ToWorld(model.Positions[body.Legs[index].Ball]) / root.Scale;
        Vector3 off = Vec.Reject(ball - place, Rotation.Rotate(root.Rotation, Vector3.UnitY));
        if (flatAt[index] is Vector3 at)
        {
            slip = Math.Max(slip, Vec.Length(Level(middle - at, root)));
            flatFrames++;
            skating += Vec.Length(Level(middle - lastMiddle[index], root)) > SkatingShareOfSpeed * Math.Max(Math.Abs(animator.Speed / root.Scale), 0.3f * body.LegLength) * dt ? 1 : 0;
        }
        else
        {
            flatAt[index] = middle;
        }

        lockDrift = Math.Max(lockDrift, foot.Normal.Y > 0.999f && body.Legs[index].FollowShare == 0f ? Vec.Length(off) : 0f);
        lastMiddle[index] = middle;
    }

    private static Vector3 Level(Vector3 v, in RootPlace root) => Vec.Reject(v, Rotation.Rotate(root.Rotation, Vector3.UnitY));

    /// <summary>Height of a point over the ground along the creature's up, negative inside it.</summary>
    private float HeightOver(Vector3 point, IGround ground)
    {
        Vector3 up = Rotation.Rotate(animator.Root.Rotation, Vector3.UnitY);
        float reach = body.LegLength * animator.Root.Scale;
        return ground.Cast(point + (up * reach), -up, 3f * reach, out GroundHit hit) ? Vec.Dot(point - hit.Point, up) : reach;
    }
}
