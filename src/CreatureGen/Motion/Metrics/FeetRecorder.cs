using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Metrics;

/// <summary>Measures the feet of a creature that goes on them: sliding, sinking, floating, clearance, legs that fall short or go into one another or the trunk, feet down, and how the pelvis rises and falls.</summary>
internal sealed class FeetRecorder
{
    private const float FlatFrom = 0.17f;
    private const float FlatTo = 0.58f;
    private const float SkatingFractionOfSpeed = 0.1f;

    /// <summary>How far the middle of a sole comes off the ground that is no longer flat but rolls over its edge, leg lengths.</summary>
    private const float RollRise = 0.002f;

    private readonly CreatureAnimator animator;
    private readonly LeggedBody body;
    private readonly FootSkin[] skins;
    private readonly LegOverlap overlap;
    private readonly Vector3?[] flatAt;
    private readonly Vector3[] lastMiddle;
    private int frames;
    private float slip;
    private float lockDrift;
    private int flatFrames;
    private int skating;
    private float penetration;
    private double penetrationSum;
    private float floating;
    private float? clearance;
    private float stanceResidual;
    private float swingResidual;
    private int stanceFrames;
    private int skinnedStanceFrames;
    private int stretched;
    private int minSupport = int.MaxValue;
    private long support;
    private float lowest = float.MaxValue;
    private float highest = float.MinValue;

    public FeetRecorder(CreatureAnimator animator, LeggedBody body)
    {
        this.animator = animator;
        this.body = body;
        overlap = new LegOverlap(body);
        skins = new FootSkin[body.Legs.Length];
        flatAt = new Vector3?[skins.Length];
        lastMiddle = new Vector3[skins.Length];
        for (int i = 0; i < skins.Length; i++)
        {
            skins[i] = new FootSkin(body.Subject, body.Legs[i].Ankle, body.Legs[i].Ball, body.Legs[i].Length);
        }
    }

    /// <summary>Measures a frame in which the creature is on its feet.</summary>
    /// <param name="dt">Seconds since the last.</param>
    /// <param name="ground">What it goes on.</param>
    /// <param name="matrices">What moves its skin.</param>
    public void Record(float dt, IGround ground, ReadOnlySpan<Matrix4x4> matrices)
    {
        Pose model = animator.ModelPose;
        int down = 0;
        for (int i = 0; i < skins.Length; i++)
        {
            FootReport foot = animator.Foot(i);
            down += foot.Phase == FootPhase.Stance ? 1 : 0;
            if (foot.Phase == FootPhase.Stance)
            {
                MeasureStance(i, foot, dt, ground, matrices);
            }
            else
            {
                MeasureSwing(i, foot, ground, matrices);
            }
        }

        overlap.Measure(model);
        frames++;
        minSupport = Math.Min(minSupport, down);
        support += down;
        float pelvis = animator.Root.ToWorld(model.Positions[body.Trunk[0]]).Y / animator.Root.Scale;
        lowest = Math.Min(lowest, pelvis);
        highest = Math.Max(highest, pelvis);
    }

    /// <summary>Tells that the creature is off its feet: what stood stands no more.</summary>
    public void LeaveGround() => Array.Clear(flatAt, 0, flatAt.Length);

    /// <summary>A report with what was measured of the feet; as it was when nothing was.</summary>
    public MotionReport AddTo(MotionReport report)
    {
        if (frames == 0)
        {
            return report;
        }

        // Of steps too quick for the rate no two frames show a foot flat: no slip is seen then.
        float length = body.LegLength;
        bool skinned = skinnedStanceFrames > 0;
        return report with
        {
            Slip = skinned ? slip / length : null,
            LockDrift = skinned ? lockDrift / length : null,
            SkatingFraction = skinned ? skating / (float)Math.Max(flatFrames, 1) : null,
            Penetration = skinned ? penetration / length : null,
            MeanPenetration = skinned ? (float)(penetrationSum / skinnedStanceFrames / length) : null,
            Float = skinned ? floating / length : null,
            Clearance = clearance / length,
            StanceResidual = stanceResidual / length,
            SwingResidual = swingResidual / length,
            StretchedFraction = stanceFrames == 0 ? null : stretched / (float)stanceFrames,
            MinSupport = minSupport,
            MeanSupport = support / (float)frames,
            Bob = (highest - lowest) / length,
            LegOverlap = overlap.Deepest / length,
            BellyOverlap = overlap.DeepestInTrunk / length,
        };
    }

    private void MeasureSwing(int index, in FootReport foot, IGround ground, ReadOnlySpan<Matrix4x4> matrices)
    {
        flatAt[index] = null;
        swingResidual = Math.Max(swingResidual, foot.Residual);
        if (skins[index].IsEmpty)
        {
            return;
        }

        float min = MinHeight(skins[index], ground, matrices);
        penetration = Math.Max(penetration, -min);
        if (foot.Progress > 0.3f && foot.Progress < 0.75f)
        {
            clearance = clearance is float known ? Math.Min(known, min) : min;
        }
    }

    private void MeasureStance(int index, in FootReport foot, float dt, IGround ground, ReadOnlySpan<Matrix4x4> matrices)
    {
        FootSkin skin = skins[index];
        RootPlace root = animator.Root;
        stanceFrames++;
        stanceResidual = Math.Max(stanceResidual, foot.Residual);
        stretched += foot.Residual > 2e-3f * body.LegLength ? 1 : 0;
        if (skin.IsEmpty)
        {
            return;
        }

        float min = MinHeight(skin, ground, matrices);
        skinnedStanceFrames++;
        penetration = Math.Max(penetration, -min);
        penetrationSum += Math.Max(-min, 0f);
        if (foot.Progress < FlatFrom || foot.Progress > FlatTo)
        {
            flatAt[index] = null;
            return;
        }

        floating = Math.Max(floating, min);
        Vector3 middle = root.ToWorld(skin.Middle(matrices)) / root.Scale;
        Vector3 at = flatAt[index] ?? middle;
        bool flat = Vec.Dot(middle - at, foot.Normal) <= RollRise * body.LegLength;
        if (flat && flatAt[index] != null)
        {
            slip = Math.Max(slip, Vec.Length(Level(middle - at)));
            flatFrames++;
            skating += Vec.Length(Level(middle - lastMiddle[index])) > SkatingFractionOfSpeed * Math.Max(Math.Abs(animator.Speed / root.Scale), 0.3f * body.LegLength) * dt ? 1 : 0;
        }

        flatAt[index] = at;
        Vector3 ball = root.ToWorld(animator.ModelPose.Positions[body.Legs[index].Ball]) / root.Scale;
        Vector3 off = Level(ball - (foot.Place / root.Scale));
        lockDrift = Math.Max(lockDrift, foot.Normal.Y > 0.999f && !body.Legs[index].Follows ? Vec.Length(off) : 0f);
        lastMiddle[index] = middle;
    }

    private float MinHeight(FootSkin skin, IGround ground, ReadOnlySpan<Matrix4x4> matrices)
    {
        RootPlace root = animator.Root;
        Vector3 up = Rotation.Rotate(root.Rotation, Vector3.UnitY);
        float reach = body.LegLength * root.Scale;
        float min = float.MaxValue;
        for (int i = 0; i < skin.Count; i++)
        {
            // Height over the ground along the creature's up, negative inside it.
            Vector3 point = root.ToWorld(skin.At(i, matrices));
            float height = ground.Cast(point + (up * reach), -up, 3f * reach, out GroundHit hit) ? Vec.Dot(point - hit.Point, up) : reach;
            min = Math.Min(min, height / root.Scale);
        }

        return min;
    }

    private Vector3 Level(Vector3 v) => Vec.Reject(v, Rotation.Rotate(animator.Root.Rotation, Vector3.UnitY));
}
