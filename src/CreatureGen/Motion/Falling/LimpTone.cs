using System;
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

    private readonly bool[] isNeck;
    private readonly float[] tendons;

    private LimpTone(bool[] isNeck, float[] tendons)
    {
        this.isNeck = isNeck;
        this.tendons = tendons;
    }

    /// <summary>All together.</summary>
    /// <param name="rig">Its parts.</param>
    public static LimpTone Together(RagdollRig rig) => new(new bool[rig.Count], new float[rig.Count]);

    /// <summary>The neck last, and legs unfold again somewhat, each as it likes.</summary>
    /// <param name="rig">Its parts.</param>
    public static LimpTone OnSide(RagdollRig rig)
    {
        var isNeck = new bool[rig.Count];
        var tendons = new float[rig.Count];
        int leg = 0;
        for (int i = 0; i < isNeck.Length; i++)
        {
            JointRole role = rig.Skeleton.Joints[rig.Parts[i].Joint].Role;
            isNeck[i] = role is JointRole.Neck or JointRole.Head;
            leg += role == JointRole.Hip ? 1 : 0;
            tendons[i] = role is JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball ? TendonTone * (1f - (Slack * (leg % 3))) : 0f;
        }

        return new LimpTone(isNeck, tendons);
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
