using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How a body heaves itself up as it draws its legs in under it: the end of the trunk whose legs ask for it, while the other stays on the ground. Raised as a whole it hung in the air over feet that passed below it.</summary>
internal sealed class TrunkHeave
{
    /// <summary>Sine up to which the trunk is pitched; beyond it all of it is raised.</summary>
    private const float Steepest = 0.5f;

    /// <summary>Least distance of the hips of the ends, leg lengths: closer ones carry the trunk together.</summary>
    private const float LeastSpan = 0.4f;

    private readonly FallProfile profile;
    private readonly bool[] isFore;
    private readonly float span;
    private readonly Heave fore = new();
    private readonly Heave hind = new();

    public TrunkHeave(FallProfile profile)
    {
        this.profile = profile;
        float first = float.MinValue;
        float last = float.MaxValue;
        foreach (LyingLeg leg in profile.Legs)
        {
            first = Math.Max(first, leg.Rig.HipRest.Z);
            last = Math.Min(last, leg.Rig.HipRest.Z);
        }

        span = first - last > LeastSpan * profile.Height ? first - last : 0f;
        isFore = Array.ConvertAll(profile.Limbs, limb => IsFore(profile.Skeleton.ModelPositions[limb.Joints[0]].Z));

        bool IsFore(float z) => z > 0.5f * (first + last);
    }

    /// <summary>Whether a leg hangs on the fore end.</summary>
    /// <param name="leg">Its number among the legs, which are the first of the limbs.</param>
    public bool IsFore(int leg) => isFore[leg];

    /// <summary>Tells what a moment asks for.</summary>
    /// <param name="moment">0 to <see cref="Heave.Parts"/>.</param>
    /// <param name="upright">How far its back is up then, −1..1: on its flank it is raised as a whole.</param>
    /// <param name="pose">How the body is without it.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="depth">How far below the ground it may be, metres of the model, not positive.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it lies on.</param>
    /// <returns>How high the middle of its trunk comes by it, metres of the model.</returns>
    public float Ask(int moment, float upright, PoseBuffer pose, in RootPlace place, float depth, Vector3 up, IGround ground)
    {
        float all = depth - profile.Support.Lowest(BodyPart.Trunk, place, pose.Model, up, ground, out _);
        float front = all;
        float rear = all;
        for (int i = 0; i < isFore.Length; i++)
        {
            float asked = depth - profile.Support.LowestOfLimb(profile.Limbs[i].Joints[0], place, pose.Model, up, ground, out _);
            front = span == 0f || isFore[i] ? Math.Max(front, asked) : front;
            rear = span == 0f || !isFore[i] ? Math.Max(rear, asked) : rear;
        }

        float apart = Scalar.Smooth(upright);
        float most = Math.Max(front, rear);
        front = Scalar.Lerp(most, front, apart);
        rear = Scalar.Lerp(most, rear, apart);
        fore.Ask(moment, front);
        hind.Ask(moment, rear);
        return profile.TrunkHeight(pose.Model) + (0.5f * (Math.Max(front, 0f) + Math.Max(rear, 0f)));
    }

    /// <summary>Makes the curves.</summary>
    public void Finish()
    {
        fore.Finish();
        hind.Finish();
    }

    /// <summary>How it is heaved up at a moment.</summary>
    /// <param name="u">0..1.</param>
    public Heaved At(float u)
    {
        float front = fore.At(u);
        float rear = hind.At(u);
        if (span == 0f)
        {
            return new Heaved(front, front, front, 0f);
        }

        float sine = (float)Scalar.Clamp((front - rear) / span, -Steepest, Steepest);
        return new Heaved(front, rear, Math.Max(front, rear) - (Math.Abs(sine) * span), (float)PortableMath.Asin(sine));
    }

    /// <summary>Takes over another.</summary>
    public void CopyFrom(TrunkHeave other)
    {
        fore.CopyFrom(other.fore);
        hind.CopyFrom(other.hind);
    }
}
