using CreatureGen.Anatomy;
using CreatureGen.Species;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>How a trunk goes with its legs: data. Angles in radians for each leg length of difference between left and right foot, or between hind and fore feet.</summary>
internal sealed record TrunkTraits
{
    /// <summary>Bank, way to the inside and bend of four-footed runners in fast turns.</summary>
    private const float RunnersBank = 0.7f;
    private const float RunnersInward = 0.7f;
    private const float RunnersBend = 0.2f;

    private static readonly TrunkTraits quadruped = new();

    /// <summary>Yaw of the pelvis with the hind feet.</summary>
    public float PelvisYaw { get; init; } = 0.16f;

    /// <summary>Yaw of the chest with the fore feet; of bipeds against the feet.</summary>
    public float ChestYaw { get; init; } = 0.12f;

    /// <summary>Roll of the pelvis, loaded side up; negative where the body leans over the foot that carries it.</summary>
    public float PelvisRoll { get; init; } = 0.045f;

    /// <summary>Roll of the chest; of bipeds with the hind feet.</summary>
    public float ChestRoll { get; init; } = 0.03f;

    /// <summary>Bend of the back as the feet gather; less of it where the feet of a girdle take turns.</summary>
    public float Flexion { get; init; } = 0.12f;

    /// <summary>Slide of a shoulder blade with its foot.</summary>
    public float ForeSlide { get; init; } = 0.26f;

    /// <summary>Slide of a hip with its foot.</summary>
    public float HindSlide { get; init; } = 0.04f;

    /// <summary>Rise of a loaded shoulder blade, leg lengths.</summary>
    public float ForeRise { get; init; } = 0.03f;

    /// <summary>Share of the chest's turns that neck and head take back.</summary>
    public float HeadSteadiness { get; init; } = 0.75f;

    /// <summary>Passive nod of the neck.</summary>
    public float Nod { get; init; } = 0.8f;

    /// <summary>Rise of the tail as the back bends, parts of the bend: it goes against the pelvis.</summary>
    public float TailLift { get; init; }

    /// <summary>Swing of the tail against the pelvis.</summary>
    public float TailYaw { get; init; } = 1.2f;

    /// <summary>Lean of a biped at a walk, radians.</summary>
    public float Lean { get; init; }

    /// <summary>Sideways lean in turns, part of the angle of balance.</summary>
    public float Bank { get; init; } = 0.6f;

    /// <summary>How far the pelvis goes over to the inside of a turn, part of the way on which the legs lean as the body does: else the hips would have to draw the legs in.</summary>
    public float Inward { get; init; } = 0.5f;

    /// <summary>Bend of the trunk in fast turns beside that of the arc under it, which is wide, part of the angle of balance.</summary>
    public float FastBend { get; init; }

    /// <summary>Head-bob of walking birds, radians at the neck's root.</summary>
    public float HeadBob { get; init; }

    /// <summary>The traits of a plan.</summary>
    /// <param name="plan">How the creature carries its body.</param>
    /// <param name="species">What its species adds: cats are suppler than dogs, and penguins waddle.</param>
    /// <param name="mass">Kilograms.</param>
    public static TrunkTraits Of(BodyPlan plan, MotionTraits species, float mass)
    {
        bool supple = species.IsSupple;
        return plan switch
        {
            BodyPlan.Digitigrade => quadruped with { ChestYaw = 0.10f, PelvisRoll = 0.055f, ChestRoll = 0.05f, Flexion = supple ? 0.44f : 0.38f, TailLift = 0.8f, ForeSlide = supple ? 0.32f : 0.28f, ForeRise = supple ? 0.05f : 0.03f, Bank = RunnersBank, Inward = RunnersInward, FastBend = RunnersBend },
            BodyPlan.Unguligrade or BodyPlan.Centaur => quadruped with { PelvisYaw = 0.10f, ChestYaw = 0.06f, PelvisRoll = 0.03f, ChestRoll = 0.02f, Flexion = 0.16f, TailLift = 0.5f, ForeSlide = 0.24f, Nod = 1.3f, Bank = RunnersBank, Inward = RunnersInward, FastBend = RunnersBend },
            BodyPlan.Plantigrade => quadruped with { PelvisYaw = 0.15f, PelvisRoll = 0.07f, ChestRoll = 0.07f, Flexion = 0.33f, TailLift = 0.8f, ForeRise = 0.045f, Nod = 1.2f, Bank = RunnersBank, Inward = RunnersInward, FastBend = RunnersBend },
            BodyPlan.Columnar => quadruped with { PelvisYaw = 0.08f, ChestYaw = 0.06f, ChestRoll = 0.035f, Flexion = 0.03f, ForeSlide = 0.20f, ForeRise = 0.02f, Nod = 1f },
            BodyPlan.Sprawling => quadruped with { PelvisYaw = 0.70f, ChestYaw = 0.55f, PelvisRoll = 0.06f, ChestRoll = 0.06f, Flexion = 0f, ForeSlide = 0.03f, ForeRise = 0f, HeadSteadiness = 0.85f, TailYaw = 1.6f },
            BodyPlan.ManyLegged => quadruped with { PelvisYaw = 0.08f, ChestYaw = 0.08f, PelvisRoll = 0.02f, ChestRoll = 0.02f, Flexion = 0f, ForeSlide = 0f, ForeRise = 0f, Bank = 0.2f },
            BodyPlan.Hexapod or BodyPlan.Buzzing => quadruped with { PelvisYaw = 0.02f, ChestYaw = 0.02f, PelvisRoll = 0.008f, ChestRoll = 0.008f, Flexion = 0f, ForeSlide = 0f, ForeRise = 0f, HeadSteadiness = 0.9f, Nod = 0.3f, Bank = 0.2f },
            BodyPlan.Theropod or BodyPlan.Flapping when species.Waddles => quadruped with { PelvisYaw = 0.30f, ChestYaw = -0.20f, PelvisRoll = -0.13f, ChestRoll = -0.13f, Lean = 0.02f, HeadSteadiness = 0.6f, TailYaw = 0.8f },
            BodyPlan.Upright => quadruped with { PelvisYaw = 0.14f, PelvisRoll = 0.06f, ChestRoll = -0.036f, Lean = 0.05f, HeadSteadiness = 0.85f },
            BodyPlan.Theropod or BodyPlan.Flapping => quadruped with { PelvisYaw = 0.15f, ChestYaw = 0.07f, PelvisRoll = 0.06f, ChestRoll = -0.036f, Lean = 0.03f, HeadSteadiness = 0.85f, TailYaw = 1.4f, HeadBob = species.BobsHead && mass < 20f ? 0.30f : 0f },
            _ => quadruped,
        };
    }
}
