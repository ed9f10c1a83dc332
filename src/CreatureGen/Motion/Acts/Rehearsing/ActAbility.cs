using System;
using System.Numerics;
using CreatureGen.Motion.Acts.Playing;

namespace CreatureGen.Motion;

/// <summary>An act as one creature can do it. Immutable, shared by all animators of the creature.</summary>
public sealed class ActAbility
{
    private readonly Lazy<ActReach?> reach;

    private readonly float[] ends;
    private readonly int lasting;
    private readonly ActGain gain;

    internal ActAbility(Act act, string? refusal, ActGain gain, float[] ends, in ActAim aim, Func<ActReach?> reach)
    {
        this.ends = ends;
        lasting = -1;
        for (int i = 0; i < act.Phases.Count; i++)
        {
            lasting = act.Phases[i].Lasts ? i : lasting;
        }

        Act = act;
        Refusal = refusal;
        this.gain = gain;
        Seconds = ends[^1];
        SecondsToContact = act.ToldIn < 0 ? null : ends[act.ToldIn];
        UsualAim = aim;
        this.reach = new Lazy<ActReach?>(reach);
    }

    /// <summary>The act.</summary>
    public Act Act { get; }

    /// <summary>Why the creature cannot do it; null where it can.</summary>
    public string? Refusal { get; }

    /// <summary>Whether the creature can do it.</summary>
    public bool IsPossible => Refusal == null;

    /// <summary>How long it takes, in calm and at standard gravity; phases that last are counted with their least time.</summary>
    public float Seconds { get; }

    /// <summary>Seconds from its beginning to its contact, or to its sound; null for acts without.</summary>
    public float? SecondsToContact { get; }

    /// <summary>Seconds from its beginning to the end of the least time of the phase that lasts; 0 for acts without.</summary>
    internal float SecondsToLast => ends.Length == 0 || lasting < 0 ? 0f : ends[lasting];

    /// <summary>Seconds from its beginning to the end of a phase, phases that last counted with their least time.</summary>
    /// <param name="phase">0 up to the number of phases.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such phase.</exception>
    public float SecondsTo(int phase) => (uint)phase < (uint)ends.Length ? ends[phase] : throw new ArgumentOutOfRangeException(nameof(phase), phase, FormattableString.Invariant($"expected 0..{ends.Length - 1}"));

    /// <summary>How far it reaches; null for acts without a target and where it is refused. Worked out when it is first asked for.</summary>
    public ActReach? Reach => reach.Value;

    /// <summary>How much of the act the body does: less where its joints, its legs or the ground leave less room.</summary>
    public float Gain => gain.Whole;

    /// <summary>The same, part by part.</summary>
    internal ActGain Parts => gain;

    /// <summary>The target that suits the creature, model space, and how the trunk helps to get there.</summary>
    internal ActAim UsualAim { get; }

    /// <summary>That target alone.</summary>
    internal Vector3 Usual => UsualAim.Target;

    /// <inheritdoc/>
    public override string ToString() => IsPossible ? Act.Name : FormattableString.Invariant($"{Act.Name}: {Refusal}");
}
