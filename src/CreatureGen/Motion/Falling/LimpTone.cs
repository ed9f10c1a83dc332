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

    private readonly bool[] isNeck;

    private LimpTone(bool[] isNeck) => this.isNeck = isNeck;

    /// <summary>All together.</summary>
    /// <param name="rig">Its parts.</param>
    public static LimpTone Together(RagdollRig rig) => new(new bool[rig.Count]);

    /// <summary>The neck last.</summary>
    /// <param name="rig">Its parts.</param>
    public static LimpTone NeckLast(RagdollRig rig)
    {
        var isNeck = new bool[rig.Count];
        for (int i = 0; i < isNeck.Length; i++)
        {
            isNeck[i] = rig.Skeleton.Joints[rig.Parts[i].Joint].Role is JointRole.Neck or JointRole.Head;
        }

        return new LimpTone(isNeck);
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
        for (int i = 0; i < tones.Length; i++)
        {
            tones[i] = isNeck[i] ? neck : rest;
        }
    }
}
