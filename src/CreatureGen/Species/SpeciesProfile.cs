using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Blueprints;

namespace CreatureGen.Species;

/// <summary>
/// What the sampler knows of one base body as the dominant one: tendencies and parts, all as data. The nine families are profiles themselves; a species starts as its family's profile
/// and says what is different.
/// </summary>
internal sealed record SpeciesProfile
{
    /// <summary>The profile of a family.</summary>
    public SpeciesProfile(string family)
    {
        Body = family;
        Family = family;
    }

    /// <summary>Name of the dominant base body.</summary>
    public string Body { get; init; }

    /// <summary>Name of the family that it belongs to.</summary>
    public string Family { get; }

    /// <summary>Whether it is one species and not a whole family.</summary>
    public bool IsSpecies => Body != Family;

    /// <summary>Its body.</summary>
    public BodyTable Table { get; init; } = null!;

    /// <summary>The group that it belongs to.</summary>
    public AnimalClass Class { get; init; }

    /// <summary>What its skin is covered with.</summary>
    public SkinCover Cover { get; init; }

    /// <summary>Size of one hair, feather, scale or plate, metres.</summary>
    public float CoverSize { get; init; } = 0.05f;

    /// <summary>What its snout wears.</summary>
    public SnoutKind Snout { get; init; }

    /// <summary>Families of its beak, where its snout wears one.</summary>
    public Weighted<BeakStyle>[] Beaks { get; init; } = Weights.Of((BeakStyle.Conical, 1.0));

    /// <summary>What surrounds its eyes.</summary>
    public EyeRim EyeRim { get; init; } = EyeRim.Lids;

    /// <summary>How it carries itself and goes.</summary>
    public MotionTraits Motion { get; init; } = new();

    /// <summary>A species of this family before it says what is different: species keep more of their own table than families do.</summary>
    public SpeciesProfile Tamed() => this with
    {
        Dominance = (0.86, 0.96),
        Kinship = 0.6,
        Variety = 0.65,
        TiltVariety = 0.35,
        LatticeSpread = 0.16,
        HeadSize = (1.06, 0.7),
        Signatures = new[] { Signature.None, Signature.BigHead, Signature.BigEyes },
    };

    /// <summary>
    /// Length of the torso of grown ones in life, shoulders to base of the tail, metres; of insects and spiders thorax and abdomen, of snakes and eels the body before the vent.
    /// About .55 to .65 of the lengths of head and body of mammals (white rhinos 3.4–4.2 m, Bactrian camels 2.3–3.5 m whose bodies measure 1.5 m: Wurihan et al. 2022), half of the lengths of birds from bill to tail
    /// (toco toucans .63 m), .7 of those of fish and of reptiles from snout to vent, a third of those of horned dinosaurs (5–8 m), a third to a fifth of plesiosaurs' (3.5–10 m, up to 7 of it neck), two thirds of insects'
    /// (ants 4–25 mm, mantises 50–90 mm), all of spiders' (wolf spiders 10–30 mm).
    /// </summary>
    public (double Min, double Max) TorsoLength { get; init; }

    /// <summary>Probability among walkers, fliers and swimmers, relative.</summary>
    public (double Walking, double Flying, double Swimming) Frequency { get; init; }

    /// <summary>Whether it is drawn only where options name its body: a species that is added so changes the creature of no seed.</summary>
    public bool OnlyByName { get; init; }

    /// <summary>Probability among the creatures of a kind, relative.</summary>
    public double FrequencyOf(LocomotionKind kind) => kind switch
    {
        LocomotionKind.Walking => Frequency.Walking,
        LocomotionKind.Flying => Frequency.Flying,
        _ => Frequency.Swimming,
    };

    /// <summary>Base bodies that mix well with it, best first.</summary>
    public string[] Partners { get; init; } = Array.Empty<string>();

    /// <summary>Share of the dominant body in the mix.</summary>
    public (double Min, double Max) Dominance { get; init; } = (0.62, 0.88);

    /// <summary>Probability that the second body is another species of the family.</summary>
    public double Kinship { get; init; }

    /// <summary>Exponent on the factors of neck, snout and tail: 1 lets them vary freely, 0 keeps the table's.</summary>
    public double Variety { get; init; } = 1;

    /// <summary>Factor on the random tilts of head, neck and tail.</summary>
    public double TiltVariety { get; init; } = 1;

    /// <summary>Largest change by a slice of the lattice.</summary>
    public double LatticeSpread { get; init; } = 0.22;

    /// <summary>Mean size of the head, and factor on its variation.</summary>
    public (double Mean, double Variation) HeadSize { get; init; } = (1.26, 1);

    /// <summary>What it may be exaggerated in; null for everything.</summary>
    public Signature[]? Signatures { get; init; }

    /// <summary>Plans of its walkers.</summary>
    public Weighted<BodyPlan>[] WalkingPlans { get; init; } = Array.Empty<Weighted<BodyPlan>>();

    /// <summary>Plans of its swimmers.</summary>
    public Weighted<BodyPlan>[] SwimmingPlans { get; init; } = Array.Empty<Weighted<BodyPlan>>();

    /// <summary>Plans of its fliers.</summary>
    public Weighted<BodyPlan>[] FlyingPlans { get; init; } = { new(BodyPlan.Flapping, 0.94), new(BodyPlan.Buzzing, 0.06) };

    /// <summary>Plans of a kind.</summary>
    public Weighted<BodyPlan>[] PlansOf(LocomotionKind kind) => kind switch
    {
        LocomotionKind.Walking => WalkingPlans,
        LocomotionKind.Flying => FlyingPlans,
        _ => SwimmingPlans,
    };

    /// <summary>Swellings and hollows of its torso, at rings from 20 on.</summary>
    public HeadBump[] Relief { get; init; } = Array.Empty<HeadBump>();

    /// <summary>Height of its hip relative to the length of the torso where the rules of the plan place its legs; null for the plan's own.</summary>
    public (double Min, double Max)? HipHeight { get; init; }

    /// <summary>The same of one that goes on two legs with its trunk level.</summary>
    public (double Min, double Max) BipedHipHeight { get; init; } = (0.78, 1.08);

    /// <summary>Whether its legs end in hooves wherever the plan leaves a choice.</summary>
    public bool IsHoofed { get; init; }

    /// <summary>What its feet with toes end in; null for what is common in its class.</summary>
    public Weighted<FootStyle>[]? Feet { get; init; }

    /// <summary>Whether its hooves are split.</summary>
    public bool IsCloven { get; init; }

    /// <summary>Tails without fins and feathers that it may have, and how likely each is; the body table's own is what is left to 1.</summary>
    public Weighted<TailStyle>[] Tails { get; init; } = Array.Empty<Weighted<TailStyle>>();

    /// <summary>Hair of its tail; null for none.</summary>
    public ManePreset? TailHair { get; init; }

    /// <summary>Factor on the girth of legs that the rules of the plan, or those for fliers, place.</summary>
    public double LegGirth { get; init; } = 1;

    /// <summary>Legs of its own, of walkers and fliers; null when the plan's rules place them.</summary>
    public LegPreset? Legs { get; init; }

    /// <summary>Legs of its swimmers; null for none.</summary>
    public LegPreset? Paddles { get; init; }

    /// <summary>Pairs of legs that its fliers have.</summary>
    public Weighted<int>[] FlierLegPairs { get; init; } = Weights.Of((1, 0.36), (2, 0.48), (0, 0.12), (3, 0.04));

    /// <summary>Tilt of the head of its swimmers, degrees; null for a random one.</summary>
    public double? SwimmingHead { get; init; }

    /// <summary>How far its swimmers lower their neck, degrees.</summary>
    public double SwimmingNeckDrop { get; init; }

    /// <summary>Proportions of a bird's legs and wings; null for all others.</summary>
    public BirdPreset? Bird { get; init; }

    /// <summary>Its thin wings; null when the rules place those of a flier.</summary>
    public ThinWings? Wings { get; init; }

    /// <summary>Its own fins; null when the plan's rules place them.</summary>
    public FinPreset? Fins { get; init; }

    /// <summary>Parts of head, back and tail: from each slot one choice. Null for the ornaments of its family.</summary>
    public PartSlot[]? Parts { get; init; }

    /// <summary>Hard cover over the back.</summary>
    public ShellBlueprint Shell { get; init; } = new(ShellStyle.None, Ring: 24, Rows: 20, Columns: 6, Rise: 0);

    /// <summary>Rings of its abdomen.</summary>
    public AnnuliBlueprint Annuli { get; init; } = new(41, 0);

    /// <summary>Radius of the stalk between its thorax and its abdomen, in that of the thinner of the two; 1 for none.</summary>
    public double Waist { get; init; } = 1;

    /// <summary>How the edges of a wide body lie back, and between which limits they hang or rise.</summary>
    public (double Sweep, double MinCurl, double MaxCurl) Disc { get; init; }

    /// <summary>Ring and segment of the eye.</summary>
    public (double Ring, double Segment) Eye { get; init; }

    /// <summary>Largest radius of an eye relative to half the head.</summary>
    public double LargestEye { get; init; } = 0.46;

    /// <summary>Probability of compound eyes.</summary>
    public double CompoundEyes { get; init; }

    /// <summary>How the eye is made when it is neither slit nor round.</summary>
    public EyeStyle EyeStyle { get; init; } = EyeStyle.Round;

    /// <summary>Radius of the eye relative to the half width of the head.</summary>
    public double EyeSize { get; init; }

    /// <summary>Depth of the eye's centre below the skin, radii.</summary>
    public double EyeSink { get; init; }

    /// <summary>Share of the forward direction in the gaze.</summary>
    public double EyeForward { get; init; }

    /// <summary>Opening of the upper and lower lid, degrees.</summary>
    public (double Upper, double Lower) LidDegrees { get; init; }

    /// <summary>Probability of slit pupils.</summary>
    public double SlitPupils { get; init; }

    /// <summary>Probability of level bar pupils where they are not slits.</summary>
    public double BarPupils { get; init; }

    /// <summary>Strength of the bony face around the eye: socket, brow, cheekbone.</summary>
    public double Bone { get; init; }

    /// <summary>Heights of the brow and cheek swellings.</summary>
    public (double Brow, double Cheek) Swelling { get; init; }

    /// <summary>The rest of its skull.</summary>
    public SkullShape Skull { get; init; } = new();

    /// <summary>How far its mouth opens at most at rest, radians.</summary>
    public double WidestMouth { get; init; } = double.PositiveInfinity;

    /// <summary>Ring of the lip corners; 0 without a mouth slit.</summary>
    public int MouthCorner { get; init; }

    /// <summary>Openings of the mouth and their weights, radians; null for those of the family.</summary>
    public Weighted<double>[]? MouthOpenings { get; init; }

    /// <summary>Form of the tongue, where there is a mouth.</summary>
    public TongueStyle Tongue { get; init; } = TongueStyle.Rounded;

    /// <summary>Colours of the tongue and their weights.</summary>
    public Weighted<Tint>[] TongueTints { get; init; } = { new(new Tint(0.60, 0.115, 14), 1) };

    /// <summary>Length of the teeth relative to the half width of the muzzle.</summary>
    public double ToothLength { get; init; } = 0.14;

    /// <summary>Exponent of the muzzle's section.</summary>
    public double MuzzleSquareness { get; init; } = 2.2;

    /// <summary>Radius of a nostril relative to the muzzle's half width.</summary>
    public double Nostril { get; init; }

    /// <summary>Mood added to the face: positive frowns.</summary>
    public double Mood { get; init; }

    /// <summary>Probability of ears and of horns.</summary>
    public (double Ears, double Horns) HeadOrnament { get; init; }

    /// <summary>Whether horns grow beside ears.</summary>
    public bool HornsBesideEars { get; init; }

    /// <summary>Whether its horns may be antlers.</summary>
    public bool Antlered { get; init; }

    /// <summary>Whether it may have tusks.</summary>
    public bool Tusked { get; init; }

    /// <summary>Probability of a crest of feathers.</summary>
    public double Crest { get; init; }

    /// <summary>Probability of hair along the neck, and of a ruff instead of bristles.</summary>
    public (double Chance, double Ruff) Hair { get; init; } = (0, 0.15);

    /// <summary>Probability of a falling mane on those that go on hooves.</summary>
    public double FallingMane { get; init; }

    /// <summary>Probability of a collar.</summary>
    public double Collar { get; init; }

    /// <summary>Probability of something along the back.</summary>
    public double BackRow { get; init; } = 0.14;

    /// <summary>Whether what is along the back may be plates or a sail.</summary>
    public bool Plated { get; init; }

    /// <summary>Whether it may carry a shell.</summary>
    public bool Shelled { get; init; }

    /// <summary>Whether its tail may end in a club or spikes.</summary>
    public bool ArmedTail { get; init; }

    /// <summary>Shapes of its ears.</summary>
    public Weighted<EarShape>[] Ears { get; init; } = { new(EarShape.Pointed, 0.6), new(EarShape.Big, 0.4) };

    /// <summary>Factor on the size of the ears.</summary>
    public double EarSize { get; init; } = 1;

    /// <summary>Probability that the wings of a flier are membranes instead of feathers; those of thin-winged species are neither.</summary>
    public double WingMembrane { get; init; } = 0.72;

    /// <summary>Families of its spread wings; null for any of its membranes or feathers.</summary>
    public Weighted<WingStyle>[]? WingStyles { get; init; }

    /// <summary>Which teeth it has, if any.</summary>
    public Dentition Dentition { get; init; } = PegTeeth.Teeth;

    /// <summary>Probability of teeth.</summary>
    public double Teeth { get; init; }

    /// <summary>Patterns of the coat.</summary>
    public Weighted<PatternKind>[] Patterns { get; init; } = Array.Empty<Weighted<PatternKind>>();

    /// <summary>Colourings that it is known by; the free palette serves where there are none, and for every third creature.</summary>
    public Colouring[] Colourings { get; init; } = Array.Empty<Colouring>();
}
