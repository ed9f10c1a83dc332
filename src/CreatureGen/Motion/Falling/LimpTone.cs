using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>How muscles let go of a body that goes limp, as data. Immutable.</summary>
internal sealed class LimpTone
{
    /// <summary>Tone that a body goes limp with, 1/s, how long it takes to go, seconds, and below what it is gone.</summary>
    private const float StartTone = 4f;
    private const float ToneSeconds = 0.35f;
    private const float LeastTone = 0.01f;

    /// <summary>That of a neck, which carries the head until the chest has come down, 1/s; how long it takes to go, τ = √(ℓ/g); and what ligaments go on to hold it with, 1/τ.</summary>
    private const float NeckTone = 40f;
    private const float NeckTime = 2.5f;
    private const float LigamentTone = 5f;

    /// <summary>That of legs, whose tendons unfold them again once the body has come down over them, 1/τ; when that begins and when it is whole, τ; and how much less it is of one leg than of the next, so that no two lie alike.</summary>
    private const float TendonTone = 3f;
    private const float TendonsBegin = 1.2f;
    private const float TendonsEnd = 3f;
    private const float Slack = 0.45f;

    /// <summary>That of wings, which fall half open, 1/τ, but on a body that rolls onto its flank, which they would prop up; how far one of them and the other is from where it was to where it is at rest, spread.</summary>
    private const float WingTone = 2f;
    private const float Opened = 0.5f;
    private const float LessOpened = 0.3f;

    private readonly bool[] isNeck;
    private readonly float[] tendons;
    private readonly float[] opened;

    private LimpTone(bool[] isNeck, float[] tendons, float[] opened)
    {
        this.isNeck = isNeck;
        this.tendons = tendons;
        this.opened = opened;
    }

    /// <summary>How muscles of a body let go.</summary>
    /// <param name="rig">Its parts.</param>
    /// <param name="neckLast">Whether its neck lets go after all else: on two legs with wings it would come down on its head.</param>
    /// <param name="unfolds">Whether its legs unfold again somewhat, each as it likes.</param>
    public static LimpTone Of(RagdollRig rig, bool neckLast, bool unfolds)
    {
        var isNeck = new bool[rig.Count];
        var tendons = new float[rig.Count];
        var opened = new float[rig.Count];
        int leg = 0;
        for (int i = 0; i < isNeck.Length; i++)
        {
            int joint = rig.Parts[i].Joint;
            JointRole role = rig.Skeleton.Joints[joint].Role;
            isNeck[i] = neckLast && (role is JointRole.Neck or JointRole.Head);
            leg += role == JointRole.Hip ? 1 : 0;
            opened[i] = role != JointRole.Wing || unfolds ? 0f : rig.Skeleton.ModelPositions[joint].X > 0f ? Opened : LessOpened;
            tendons[i] = opened[i] > 0f ? WingTone
                : unfolds && (role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball) ? TendonTone * (1f - (Slack * (leg % 3)))
                : 0f;
        }

        return new LimpTone(isNeck, tendons, opened);
    }

    /// <summary>Has muscles pull to where they would let parts come to: wings to half open.</summary>
    /// <param name="targets">Turns from rest, in the parents' axes.</param>
    public void Relax(Span<Quaternion> targets)
    {
        for (int i = 0; i < targets.Length; i++)
        {
            targets[i] = opened[i] > 0f ? Rotation.Nlerp(targets[i], Quaternion.Identity, opened[i]) : targets[i];
        }
    }

    /// <summary>Writes the tone of each part.</summary>
    /// <param name="seconds">Since it went limp.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    /// <param name="tones">Receives them, 1/s.</param>
    public void Write(float seconds, float tau, Span<float> tones)
    {
        float rest = StartTone * (float)PortableMath.Exp(-seconds / ToneSeconds);
        rest = rest < LeastTone ? 0f : rest;
        float neck = (LigamentTone / tau) + (NeckTone * (float)PortableMath.Exp(-seconds / (NeckTime * tau)));
        float tendon = Scalar.Smooth(((seconds / tau) - TendonsBegin) / (TendonsEnd - TendonsBegin)) / tau;
        for (int i = 0; i < tones.Length; i++)
        {
            tones[i] = isNeck[i] ? neck : rest + (tendons[i] * tendon);
        }
    }
}
