using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>
/// How bodies on five pairs of legs and more do things: their feet leave the trunk no room, so that they raise the front of it with its feet, as centipedes and caterpillars do, and swing that; and lie bent
/// to a side.
/// </summary>
internal static class RaisedFronts
{
    /// <summary>Reared up it drops onto what it bites, and wrenches it from side to side.</summary>
    public static readonly Act Bite = Free(new Act("Bite", ActKind.Strike,
        new ActPhase("rear", 1.9f).To(FrontUp, 0.75f).To(ForeFeetUp, 0.1f).To(ForeFeetAhead, 0.1f).To(NeckPitch, 0.2f).To(Jaw, 0.3f).To(Ears, 0.6f).To(TailPitch, 0.3f).AtLeast(Attacks.Seen).Then(ActMark.Commit),
        new ActPhase("strike", 0.75f, ActEase.In).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(Ahead, 0.15f).To(NeckPitch, 0f).To(Jaw, 1f).To(Reach, 0.85f),
        new ActPhase("shut", 0.22f, ActEase.Out).To(Jaw, 0.1f).To(Reach, 1f).To(Ears, 1f).To(Lids, 0.6f).Then(ActMark.Contact),
        new ActPhase("wrench", 2.4f).To(Reach, 0.3f).To(FrontUp, 0.35f).To(Ahead, -0.05f).With(new ActWave(FrontSide, 0.3f, 2f)).With(new ActWave(HeadSide, 0.2f, 2f, 0.1f)).With(new ActWave(HeadRoll, 0.35f, 2f)).With(new ActWave(ForeFootUp, 0.1f, 2f)).With(new ActWave(TailSide, 0.4f, 2f, 0.3f)),
        new ActPhase("recover", 2f).To(Reach, 0f).To(FrontUp, 0f).To(Ahead, 0f).To(Jaw, 0f).To(Lids, 0f).To(Ears, 0f).To(TailPitch, 0f))
        .With(ActTool.Mouth, 0.15f), ActNeeds.Head);

    /// <summary>It takes what lies before it up with it, turns it between its fore feet, and goes down for more.</summary>
    public static readonly Act Eat = Of(new Act("Eat", ActKind.Upkeep,
        new ActPhase("down", 3.2f).To(Reach, 0.92f).To(Jaw, 0.45f).To(Ears, -0.2f).To(TailPitch, 0.12f),
        new ActPhase("bite", 0.8f).To(Reach, 1f).To(Jaw, 0f).Then(ActMark.Contact),
        new ActPhase("raise", 2.4f).To(Reach, 0f).To(FrontUp, 0.6f).To(NeckPitch, -0.1f).To(HeadPitch, -0.3f).To(ForeFeetUp, 0.26f).To(ForeFeetAhead, 0.15f).To(ForeFeetOut, -0.2f),
        new ActPhase("chew", 8f).With(new ActWave(FrontUp, 0.05f, 2f)).With(new ActWave(FrontSide, 0.12f, 1f)).With(new ActWave(Jaw, 0.28f, 7f, 0.25f)).With(new ActWave(HeadPitch, 0.1f, 7f)).With(new ActWave(HeadRoll, 0.15f, 3f)).With(new ActWave(ForeFootAhead, 0.14f, 7f)).With(new ActWave(ForeFeetUp, 0.06f, 3.5f)).With(new ActWave(Ears, 0.35f, 3f)).With(new ActWave(TailSide, 0.4f, 1.5f)),
        new ActPhase("put down", 2f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f).To(HeadPitch, 0f),
        new ActPhase("level", 1.4f).To(NeckPitch, 0f).To(Ears, 0f).To(TailPitch, 0f))
        .With(ActTool.Mouth, 0.95f), ActNeeds.Head);

    /// <summary>Reared up it comes down with a fore foot.</summary>
    public static readonly Act Claw = Of(new Act("Claw", ActKind.Strike,
        new ActPhase("rear", 1.8f).To(FrontUp, 0.8f).To(ForeFootUp, 0.2f).To(ForeFootOut, 0.3f).To(ForeFootPitch, 0.6f).To(FrontSide, -0.15f).To(NeckPitch, 0.2f).To(NeckSide, -0.2f).To(Jaw, 0.35f).To(Ears, 0.8f).To(TailPitch, 0.3f).AtLeast(Attacks.Seen).Then(ActMark.Commit),
        new ActPhase("strike", 0.6f, ActEase.In).To(FrontUp, 0.3f).To(FrontSide, 0.1f).To(ForeFootPitch, -0.3f).To(NeckPitch, 0f).To(NeckSide, 0.1f).To(Jaw, 0.7f).To(Reach, 0.85f),
        new ActPhase("hit", 0.2f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
        new ActPhase("rake", 0.8f, ActEase.Out).To(Reach, 0f).To(FrontUp, 0.15f).To(ForeFootUp, 0f).To(ForeFootAhead, 0.12f).To(ForeFootOut, -0.2f).To(ForeFootPitch, 0.2f).To(NeckPitch, -0.2f),
        new ActPhase("down", 1.3f).To(FrontUp, 0f).To(FrontSide, 0f).To(ForeFootAhead, 0f).To(ForeFootOut, 0f).To(ForeFootPitch, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(Jaw, 0f),
        new ActPhase("recover", 1.4f).To(Ears, 0f).To(TailPitch, 0f))
        .With(ActTool.ForeFoot), ActNeeds.Legs);

    /// <summary>As caterpillars seek the next leaf: up, from side to side, farther up, and down ahead.</summary>
    public static readonly Act Sniff = Free(new Act("Sniff", ActKind.Upkeep,
        new ActPhase("towards", 2.2f).To(Reach, 1f).To(Ears, -0.7f).To(TailPitch, 0.2f).Then(ActMark.Contact),
        new ActPhase("rise", 2f).To(Reach, 0f).To(FrontUp, 0.45f).To(HeadPitch, -0.15f).To(ForeFeetUp, 0.1f),
        new ActPhase("weave", 7f).To(FrontUp, 0.6f).With(new ActWave(FrontSide, 0.55f, 2f)).With(new ActWave(FrontUp, 0.1f, 4f, 0.25f)).With(new ActWave(NeckSide, 0.3f, 2f, 0.12f)).With(new ActWave(HeadSide, 0.2f, 2f, 0.2f)).With(new ActWave(HeadPitch, 0.1f, 8f)).With(new ActWave(ForeFootUp, 0.12f, 4f)).With(new ActWave(ForeFootAhead, 0.12f, 4f, 0.25f)).With(new ActWave(Ears, 0.4f, 6f, 0.3f)).With(new ActWave(TailSide, 0.3f, 2f, 0.4f)),
        new ActPhase("scent", 2f).To(FrontUp, 0.9f).To(HeadPitch, 0.2f).With(new ActWave(Jaw, 0.05f, 5f)),
        new ActPhase("back", 2.4f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(TailPitch, 0f))
        .With(ActTool.Mouth, 0.4f), ActNeeds.Head);

    /// <summary>The front off the ground it shakes that, and the tail with it.</summary>
    public static readonly Act Shake = Of(new Act("Shake", ActKind.Upkeep,
        new ActPhase("crouch", 1.2f).To(ForeDown, 0.2f).To(HindDown, 0.2f).To(NeckPitch, -0.3f).To(Ears, 0.3f).To(Lids, 1f),
        new ActPhase("rise", 1.2f).To(ForeDown, 0f).To(HindDown, 0f).To(FrontUp, 0.4f).To(ForeFeetUp, 0.1f).To(NeckPitch, 0f).To(TailPitch, 0.35f),
        new ActPhase("shake", 7f).With(new ActWave(FrontSide, 0.3f, 6f)).With(new ActWave(HeadRoll, 0.5f, 6f, 0.2f)).With(new ActWave(NeckSide, 0.35f, 6f, 0.15f)).With(new ActWave(HeadSide, 0.2f, 6f, 0.25f)).With(new ActWave(ForeFootUp, 0.15f, 6f, 0.1f)).With(new ActWave(TailSide, 1.1f, 6f, 0.35f)).With(new ActWave(TailPitch, 0.22f, 12f, 0.35f)).With(new ActWave(Ears, 0.9f, 6f, 0.1f)).With(new ActWave(Wings, 0.3f, 6f, 0.2f)),
        new ActPhase("stretch", 1.4f).To(FrontUp, 0.7f).To(NeckPitch, 0.2f).To(Ears, -0.3f).To(Lids, 0f),
        new ActPhase("recover", 1.8f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(NeckPitch, 0f).To(TailPitch, 0f).To(Ears, 0f)), ActNeeds.Head);

    /// <summary>It draws head and feelers past its raised fore feet.</summary>
    public static readonly Act Groom = Of(new Act("Groom", ActKind.Upkeep,
        new ActPhase("raise", 2f).To(FrontUp, 0.6f).To(NeckPitch, -0.35f).To(HeadPitch, -0.4f).To(ForeFeetUp, 0.3f).To(ForeFeetAhead, 0.2f).To(ForeFeetOut, -0.25f).To(Ears, 0.4f),
        new ActPhase("rub", 9f).With(new ActWave(FrontSide, 0.22f, 2f)).With(new ActWave(ForeFootAhead, 0.16f, 8f)).With(new ActWave(ForeFeetUp, 0.08f, 4f)).With(new ActWave(NeckSide, 0.4f, 2f, 0.1f)).With(new ActWave(HeadSide, 0.35f, 2f, 0.15f)).With(new ActWave(HeadRoll, 0.3f, 2f, 0.2f)).With(new ActWave(HeadPitch, 0.12f, 4f)).With(new ActWave(Ears, 0.4f, 4f)),
        new ActPhase("lower", 2f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f).To(Ears, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f)), ActNeeds.Head);

    /// <summary>It calls from as high as it gets its mouth.</summary>
    public static readonly Act Call = Free(new Act("Call", ActKind.Display,
        new ActPhase("breath", 2f).To(ForeDown, 0.1f).To(NeckPitch, -0.3f).To(HeadPitch, -0.2f).To(TailPitch, -0.1f).AtLeast(0.2f).Then(ActMark.SoundBegin),
        new ActPhase("burst", 1.2f, ActEase.Over).To(ForeDown, 0f).To(FrontUp, 0.7f).To(NeckPitch, 0.3f).To(HeadPitch, 0.25f).To(Jaw, 1f).To(Ears, 0.6f).To(Lids, 0.3f).To(TailPitch, 0.4f).To(Wings, 0.4f),
        new ActPhase("sustain", 4.5f).To(Jaw, 0.85f).With(new ActWave(FrontSide, 0.15f, 1f)).With(new ActWave(HeadSide, 0.2f, 1f, 0.1f)).With(new ActWave(Jaw, 0.05f, 12f)).With(new ActWave(HeadPitch, 0.02f, 12f)),
        new ActPhase("close", 0.9f).To(Jaw, 0f).Then(ActMark.SoundEnd),
        new ActPhase("recover", 2f).To(FrontUp, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(Lids, 0f).To(TailPitch, 0f).To(Wings, 0f)), ActNeeds.Jaw);

    /// <summary>Reared up as far as it goes, fore feet spread and beating, it sways.</summary>
    public static readonly Act Threaten = Of(new Act("Threaten", ActKind.Display,
        new ActPhase("gather", 1.6f).To(Ahead, -0.1f).To(ForeDown, 0.2f).To(NeckPitch, -0.3f).To(HeadPitch, -0.2f).To(Ears, 0.9f),
        new ActPhase("rear", 1.8f).To(ForeDown, 0f).To(FrontUp, 1f).To(ForeFeetUp, 0.15f).To(ForeFeetOut, 0.3f).To(NeckPitch, 0.2f).To(HeadPitch, 0.15f).To(Jaw, 0.9f).To(TailPitch, 0.8f).To(TailCurl, 0.5f).To(Wings, 0.8f),
        new ActPhase("show", 6f).To(Ahead, 0f).With(new ActWave(FrontSide, 0.35f, 2f)).With(new ActWave(FrontUp, 0.08f, 4f)).With(new ActWave(ForeFootUp, 0.2f, 4f)).With(new ActWave(ForeFootAhead, 0.25f, 4f, 0.25f)).With(new ActWave(NeckSide, -0.2f, 2f, 0.1f)).With(new ActWave(HeadSide, 0.15f, 2f, 0.15f)).With(new ActWave(TailSide, 0.5f, 2f, 0.3f)),
        new ActPhase("drop", 1.8f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(ForeFeetOut, 0f).To(Jaw, 0f),
        new ActPhase("recover", 1.6f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(Wings, 0f)), ActNeeds.Legs);

    /// <summary>The front hardly off the ground, bent away, head bowed below it.</summary>
    public static readonly Act Submit = Of(new Act("Submit", ActKind.Display,
        new ActPhase("crouch", 1.8f).To(ForeDown, 0.5f).To(HindDown, 0.4f).To(NeckPitch, -0.3f).To(HeadPitch, -0.2f).To(Ears, 1f).To(TailPitch, -0.3f).To(TailCurl, -0.3f).To(Wings, -0.4f),
        new ActPhase("turn away", 2f).To(FrontUp, 0.16f).To(FrontSide, 0.9f).To(ForeFeetUp, 0.1f).To(NeckPitch, -0.6f).To(NeckSide, 0.5f).To(HeadSide, 0.3f).To(HeadRoll, 0.4f).To(TailSide, 0.6f).To(Lids, 0.4f),
        new ActPhase("stay", 6f).With(new ActWave(FrontUp, 0.02f, 4f)).With(new ActWave(HeadSide, 0.08f, 1f)).With(new ActWave(TailSide, 0.12f, 2f)),
        new ActPhase("look up", 1.6f).To(FrontSide, 0.4f).To(NeckPitch, -0.1f).To(NeckSide, 0f).To(HeadPitch, 0.2f).To(HeadSide, -0.1f).To(HeadRoll, 0f).To(Lids, 0f),
        new ActPhase("rise", 2.4f).To(FrontUp, 0f).To(FrontSide, 0f).To(ForeFeetUp, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadSide, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailSide, 0f).To(TailCurl, 0f).To(Wings, 0f)), ActNeeds.Head);

    /// <summary>Raised, it sways over from side to side with its feet beating the time, higher in the second half, and bows.</summary>
    public static readonly Act Dance = Of(new Act("Dance", ActKind.Display,
        new ActPhase("rear", 2.2f).To(FrontUp, 0.65f).To(ForeFeetUp, 0.12f).To(ForeFeetOut, 0.15f).To(TailPitch, 0.5f).To(Ears, -0.4f).To(Wings, 0.4f),
        new ActPhase("sway", 8f).With(new ActWave(FrontSide, 0.6f, 3f)).With(new ActWave(FrontUp, 0.14f, 6f, 0.25f)).With(new ActWave(NeckSide, -0.3f, 3f, 0.1f)).With(new ActWave(HeadRoll, 0.3f, 3f, 0.1f)).With(new ActWave(ForeFootUp, 0.2f, 6f)).With(new ActWave(ForeFootAhead, 0.2f, 6f, 0.25f)).With(new ActWave(TailSide, 0.9f, 3f, 0.35f)).With(new ActWave(Wings, 0.3f, 6f)),
        new ActPhase("higher", 1f).To(FrontUp, 0.9f),
        new ActPhase("sway again", 8f).With(new ActWave(FrontSide, -0.5f, 4f)).With(new ActWave(FrontUp, 0.12f, 8f, 0.25f)).With(new ActWave(NeckSide, 0.3f, 4f, 0.1f)).With(new ActWave(HeadRoll, -0.3f, 4f, 0.1f)).With(new ActWave(ForeFeetUp, 0.12f, 8f)).With(new ActWave(ForeFootAhead, 0.25f, 8f)).With(new ActWave(TailSide, -0.9f, 4f, 0.35f)).With(new ActWave(Wings, 0.3f, 8f)),
        new ActPhase("bow", 2f).To(FrontUp, 0.1f).To(NeckPitch, -0.4f).To(HeadPitch, -0.2f).To(ForeFeetOut, 0.3f),
        new ActPhase("rise", 2f).To(FrontUp, 0f).To(ForeFeetUp, 0f).To(ForeFeetOut, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(TailPitch, 0f).To(Ears, 0f).To(Wings, 0f)), ActNeeds.Legs);

    /// <summary>It starts up and aside from what is before it, feet drawn in, and hangs there.</summary>
    public static readonly Act Flinch = Flinches.Of(
        new ActPhase("start", 0.9f, ActEase.Out).To(FrontUp, 0.6f).To(FrontSide, -0.6f).To(ForeFeetUp, 0.25f).To(ForeFeetOut, -0.15f).To(Ahead, -0.1f).To(NeckPitch, -0.1f).To(HeadPitch, -0.6f).To(NeckSide, -0.5f).To(HeadSide, -0.3f).To(Ears, 1f).To(Lids, 1f).To(TailPitch, 0.7f).To(TailCurl, 0.8f).To(TailSide, 0.4f).To(Wings, 0.6f),
        new ActPhase("freeze", 2f).To(FrontUp, 0.5f).To(TailCurl, 0.6f).With(new ActWave(FrontSide, 0.02f, 6f)).With(new ActWave(TailSide, 0.1f, 4f)),
        new ActPhase("look", 1.4f).To(FrontSide, -0.35f).To(Lids, -0.2f).To(HeadPitch, 0f).To(NeckSide, 0f).To(HeadSide, 0.2f).To(Ears, -0.4f))
        .Needing(ActNeeds.Front).For(BodyBuild.ManyLegged);

    private static Act Of(Act act, ActNeeds needs) => Free(act, needs).OnTheSpot();

    /// <summary>One that is done at a walk too.</summary>
    private static Act Free(Act act, ActNeeds needs) => act.Needing(ActNeeds.Front | needs).For(BodyBuild.ManyLegged);
}
