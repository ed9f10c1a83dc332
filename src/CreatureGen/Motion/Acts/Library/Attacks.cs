using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>Acts that strike. What a player has to see coming takes 0.18 s at least.</summary>
internal static class Attacks
{
    internal const float Seen = 0.18f;

    public static readonly Act[] All =
    {
        new Act("Bite", ActKind.Strike,
            new ActPhase("rise", 1.8f).To(NeckPitch, 1.0f).To(HeadPitch, -0.9f).To(Ears, 0.5f).AtLeast(Seen),
            new ActPhase("draw", 0.8f).To(NeckPitch, 1.15f).To(HeadPitch, -0.8f).To(Jaw, 0.4f).Then(ActMark.Commit),
            new ActPhase("strike", 0.5f, ActEase.In).To(Jaw, 1f).To(Reach, 0.8f).To(NeckPitch, 0.3f).To(HeadPitch, -0.1f),
            new ActPhase("shut", 0.25f, ActEase.Out).To(Jaw, 0.15f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("hold", 0.5f),
            new ActPhase("recover", 2.4f).To(Reach, 0f).To(Jaw, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth, 0.1f).For(BodyBuild.Legless),
        new Act("Bite", ActKind.Strike,
            new ActPhase("draw", 1.8f).To(Ahead, -0.7f).To(BackSide, 0.35f).To(NeckPitch, 0.2f).To(NeckSide, -0.2f).To(Jaw, 0.25f).To(Wings, 0.6f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.8f, ActEase.In).To(Ahead, 0f).To(BackSide, -0.2f).To(NeckPitch, 0f).To(NeckSide, 0.1f).To(Jaw, 1f).To(Reach, 0.85f).To(Wings, -0.6f),
            new ActPhase("shut", 0.25f, ActEase.Out).To(Jaw, 0f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("wrench", 2.4f).With(new ActWave(BackSide, 0.4f, 2f)).With(new ActWave(Roll, 0.35f, 2f, 0.2f)).With(new ActWave(HeadRoll, 0.2f, 2f)),
            new ActPhase("recover", 3f).To(Reach, 0f).To(BackSide, 0f).To(NeckSide, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth).For(BodyBuild.Swimming),
        new Act("Bite", ActKind.Strike,
            new ActPhase("draw", 3f).To(Ahead, -0.8f).To(Up, 0.8f).To(Pitch, 0.2f).To(NeckPitch, 0.5f).To(HeadPitch, -0.4f).To(Jaw, 0.25f).To(TailPitch, -0.3f).To(Wings, 0.35f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("stoop", 1.6f, ActEase.In).To(Ahead, 0f).To(Up, 0f).To(Pitch, -0.35f).To(NeckPitch, 0f).To(HeadPitch, 0.2f).To(Jaw, 1f).To(Reach, 0.85f).To(TailPitch, 0.3f).To(Wings, 0f),
            new ActPhase("shut", 0.4f, ActEase.Out).To(Jaw, 0f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("wrench", 3f).To(Pitch, 0.15f).With(new ActWave(NeckSide, 0.25f, 2f)).With(new ActWave(HeadRoll, 0.25f, 2f)).With(new ActWave(Roll, 0.25f, 2f, 0.2f)),
            new ActPhase("recover", 6f).To(Reach, 0f).To(Pitch, 0f).To(HeadPitch, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth).For(BodyBuild.Airborne),
        RaisedFronts.Bite,
        BiteOnLegs(-0.25f, 0.15f, new ActPhase("wrench", 1.5f).With(new ActWave(HeadSide, 0.2f, 1.5f)).With(new ActWave(HeadRoll, 0.35f, 1.5f))).For(BodyBuild.ManyLegged | BodyBuild.Sprawling),
        BiteOnLegs(0.10f, 0f, new ActPhase("wrench", 1.5f).With(new ActWave(BackSide, 0.12f, 1.5f)).With(new ActWave(HeadRoll, 0.25f, 1.5f))).For(BodyBuild.Standing),
        BiteOnLegs(0.10f, 0f, new ActPhase("wrench", 1.5f).With(new ActWave(HeadSide, 0.2f, 1.5f)).With(new ActWave(HeadRoll, 0.35f, 1.5f))).For(BodyBuild.ManyLegged | BodyBuild.Sprawling),
        new Act("Gore", ActKind.Strike,
            new ActPhase("lower", 1.6f).To(Ahead, -0.22f).To(ForeDown, 0.18f).To(NeckPitch, -0.45f).To(HeadPitch, -0.35f).To(Ears, 0.8f).To(TailPitch, 0.4f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.6f, ActEase.In).To(Ahead, 0.05f).To(Reach, 0.8f),
            new ActPhase("hit", 0.25f, ActEase.Out).To(Reach, 1f).To(Ahead, 0.1f).Then(ActMark.Contact),
            new ActPhase("hook", 0.8f, ActEase.Out).To(Reach, 0.15f).To(ForeDown, 0.05f).To(NeckPitch, 0.5f).To(HeadPitch, 0.15f).To(HeadRoll, 0.3f).To(NeckSide, 0.2f),
            new ActPhase("recover", 2.2f).To(Reach, 0f).To(Ahead, 0f).To(ForeDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(NeckSide, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Horns | ActNeeds.Head).With(ActTool.Brow, 0.2f).For(BodyBuild.Standing),
        ClawOfArms(1f).Needing(ActNeeds.Arms | ActNeeds.Legs).For(BodyBuild.TwoLegged | BodyBuild.Upright),
        ClawOfArms(0.4f).Needing(ActNeeds.Arms | ActNeeds.Legs).For(BodyBuild.Standing),
        new Act("Claw", ActKind.Strike,
            new ActPhase("raise", 1.7f).To(Aside, -0.10f).To(Ahead, -0.12f).To(HindDown, 0.10f).To(Yaw, -0.04f).To(ForeFootUp, 0.5f).To(ForeFootAhead, -0.02f).To(ForeFootOut, 0.22f).To(ForeFootPitch, 0.9f).To(NeckPitch, 0.3f).To(NeckSide, -0.2f).To(Ears, 0.8f).To(Jaw, 0.35f).To(TailPitch, 0.3f).To(TailSide, 0.5f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.5f, ActEase.In).To(Ahead, 0.12f).To(ForeDown, 0.04f).To(HindDown, 0f).To(Yaw, 0.02f).To(ForeFootPitch, -0.4f).To(NeckPitch, 0f).To(NeckSide, 0.1f).To(TailSide, -0.5f).To(Jaw, 0.7f).To(Reach, 0.85f),
            new ActPhase("hit", 0.2f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("rake", 0.7f, ActEase.Out).To(Reach, 0f).To(Ahead, 0.04f).To(ForeDown, 0.14f).To(Yaw, 0.03f).To(ForeFootUp, 0.2f).To(ForeFootAhead, 0.22f).To(ForeFootOut, -0.22f).To(ForeFootPitch, 0.2f).To(NeckPitch, -0.2f),
            new ActPhase("down", 1.3f).To(ForeDown, 0f).To(Yaw, 0f).To(ForeFootUp, 0f).To(ForeFootAhead, 0f).To(ForeFootOut, 0f).To(ForeFootPitch, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(TailSide, 0f).To(Jaw, 0f),
            new ActPhase("recover", 1.4f).To(Aside, 0f).To(Ahead, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.FourLegs).With(ActTool.ForeFoot).For(BodyBuild.Pawed | BodyBuild.Sprawling).OnTheSpot(),
        RaisedFronts.Claw,
        new Act("Claw", ActKind.Strike,
            new ActPhase("rear", 1.7f).To(Ahead, -0.06f).To(ForeFeetUp, 0.35f).To(ForeFeetAhead, 0.1f).To(ForeFootUp, 0.25f).To(ForeFootOut, 0.25f).To(ForeFootPitch, 0.6f).To(NeckPitch, 0.3f).To(NeckSide, -0.2f).To(Jaw, 0.35f).To(Ears, 0.8f).To(TailPitch, 0.3f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.5f, ActEase.In).To(Ahead, 0.06f).To(ForeFootPitch, -0.3f).To(NeckPitch, 0f).To(NeckSide, 0.1f).To(Jaw, 0.7f).To(Reach, 0.85f),
            new ActPhase("hit", 0.2f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("rake", 0.7f, ActEase.Out).To(Reach, 0f).To(Ahead, 0.03f).To(ForeFeetUp, 0.2f).To(ForeFootUp, 0f).To(ForeFootAhead, 0.12f).To(ForeFootOut, -0.2f).To(ForeFootPitch, 0.2f).To(NeckPitch, -0.2f),
            new ActPhase("down", 1.3f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFootAhead, 0f).To(ForeFootOut, 0f).To(ForeFootPitch, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(Jaw, 0f),
            new ActPhase("recover", 1.4f).To(Ahead, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.FourLegs).With(ActTool.ForeFoot).For(BodyBuild.ManyLegged).OnTheSpot(),
        new Act("Kick", ActKind.Strike,
            new ActPhase("look", 1.4f).To(NeckSide, 0.5f).To(HeadSide, 0.3f).To(Ears, 0.8f).To(Ahead, 0.08f).AtLeast(Seen),
            new ActPhase("fold", 0.9f).To(Pitch, -0.12f).To(NeckPitch, -0.3f).To(HindFeetUp, 0.22f).To(HindFeetAhead, 0.08f).To(ForeDown, 0.05f).Then(ActMark.Commit),
            new ActPhase("strike", 0.4f, ActEase.In).To(Pitch, -0.22f).To(HindFeetUp, 0.42f).To(HindFeetAhead, -0.5f).To(Reach, 0.9f),
            new ActPhase("hit", 0.15f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("fold back", 1.1f).To(Reach, 0f).To(Pitch, -0.1f).To(HindFeetUp, 0.2f).To(HindFeetAhead, 0f),
            new ActPhase("land", 0.8f).To(Pitch, 0f).To(HindFeetUp, 0f).To(HindDown, 0.08f),
            new ActPhase("recover", 1.8f).To(Ahead, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(ForeDown, 0f).To(HindDown, 0f))
            .Needing(ActNeeds.FourLegs).With(ActTool.HindFoot).For(BodyBuild.Hoofed | BodyBuild.Columnar | BodyBuild.Pawed).OnTheSpot(),
        new Act("Kick", ActKind.Strike,
            new ActPhase("raise", 1.5f).To(Aside, -0.16f).To(Ahead, -0.06f).To(HindFootUp, 0.5f).To(HindFootAhead, 0.12f).To(HindFootPitch, 0.5f).To(ArmsOut, 0.5f).To(Wings, 0.5f).To(NeckPitch, 0.2f).To(Jaw, 0.3f).To(TailPitch, -0.2f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.45f, ActEase.In).To(HindFootPitch, -0.4f).To(Pitch, 0.3f).To(NeckPitch, -0.1f).To(Reach, 0.9f),
            new ActPhase("hit", 0.18f, ActEase.Out).To(Pitch, 0.35f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("fold back", 1.4f).To(Reach, 0f).To(Pitch, 0.1f).To(Ahead, 0.03f).To(HindFootUp, 0.35f).To(HindFootAhead, 0.05f).To(HindFootPitch, 0.3f).To(Jaw, 0f),
            new ActPhase("land", 1.1f).To(Pitch, 0f).To(HindFootUp, 0f).To(HindFootAhead, 0f).To(HindFootPitch, 0f).To(HindDown, 0.1f),
            new ActPhase("recover", 1.4f).To(Aside, 0f).To(Ahead, 0f).To(HindDown, 0f).To(NeckPitch, 0f).To(ArmsOut, 0f).To(Wings, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Legs).With(ActTool.HindFoot).For(BodyBuild.TwoLegged | BodyBuild.Upright).OnTheSpot(),
        OverBack().Needing(ActNeeds.Sting | ActNeeds.Legs).For(BodyBuild.Standing),
        new Act("Sting", ActKind.Strike,
            new ActPhase("cock", 1.6f).To(TailPitch, -0.4f).To(HindDown, -0.3f).To(ForeDown, 0.15f).To(NeckPitch, 0.2f).To(Wings, 0.5f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("strike", 0.5f, ActEase.In).To(TailPitch, -0.8f).To(TailCurl, -0.6f).To(Ahead, -0.05f).To(Reach, 0.85f),
            new ActPhase("hit", 0.2f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("pump", 1.6f).With(new ActWave(TailCurl, 0.1f, 3f)).With(new ActWave(Ahead, 0.02f, 3f)),
            new ActPhase("recover", 2.2f).To(Reach, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(HindDown, 0f).To(ForeDown, 0f).To(Ahead, 0f).To(NeckPitch, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Abdomen | ActNeeds.Legs).With(ActTool.Tail).For(BodyBuild.ManyLegged | BodyBuild.Sprawling).OnTheSpot(),
        OverBack().Needing(ActNeeds.LongTail | ActNeeds.Legs).For(BodyBuild.ManyLegged),
        new Act("TailSweep", ActKind.Strike,
            new ActPhase("look", 1.2f).To(NeckSide, 1f).To(HeadSide, 0.4f).To(Ears, 0.6f).To(Aside, 0.06f).To(HindDown, 0.06f),
            new ActPhase("wind", 1.8f).To(Yaw, -0.4f).To(BackSide, 0.4f).To(TailSide, 1.8f).To(TailPitch, 0.2f).To(HindDown, 0.18f).To(Roll, -0.05f).To(Jaw, 0.3f).AtLeast(Seen).Then(ActMark.Commit),
            new ActPhase("sweep", 0.9f, ActEase.In).To(Aside, -0.06f).To(Yaw, 0.25f).To(BackSide, -0.25f).To(TailSide, 0.3f).To(HindDown, 0.06f).To(Roll, 0.05f),
            new ActPhase("hit", 0.45f, ActEase.Out).To(Yaw, 0.4f).To(BackSide, -0.45f).To(TailSide, -1.7f).To(TailPitch, 0.05f).To(NeckSide, 0.6f).Then(ActMark.Contact),
            new ActPhase("follow", 0.9f, ActEase.Out).To(Yaw, 0.42f).To(TailSide, -2f).To(TailCurl, 0.25f),
            new ActPhase("recover", 2.6f).To(Yaw, 0f).To(BackSide, 0f).To(TailSide, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(HindDown, 0f).To(Aside, 0f).To(Roll, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(Jaw, 0f).To(Ears, 0f))
            .Needing(ActNeeds.LongTail | ActNeeds.Legs).For(BodyBuild.Standing).OnTheSpot(),
    };

    /// <summary>Drawn back over the feet, struck out, and wrenched to and fro and back: by the back, or by the head alone where low legs, or many, leave that no room.</summary>
    /// <param name="drawn">How far the chest is let down as it draws back: low bodies and many legs raise it, whose necks are short.</param>
    /// <param name="thrown">How far ahead of where it stands and down the trunk is thrown besides.</param>
    /// <param name="wrench">What it does with what it has bitten.</param>
    private static Act BiteOnLegs(float drawn, float thrown, ActPhase wrench) => new Act("Bite", ActKind.Strike,
        new ActPhase("draw", 1.4f).To(Ahead, -0.18f).To(ForeDown, drawn).To(HindDown, 0.08f).To(NeckPitch, 0.35f).To(Jaw, 0.25f).To(Ears, 0.6f).To(TailPitch, -0.15f).To(ArmsBend, 0.5f).AtLeast(Seen).Then(ActMark.Commit),
        new ActPhase("strike", 0.55f, ActEase.In).To(Ahead, 0.04f + thrown).To(ForeDown, 0.10f + thrown).To(NeckPitch, 0f).To(Jaw, 1f).To(Reach, 0.85f).To(TailPitch, 0.4f).To(ArmsBend, 0f).To(ArmsAhead, 0.3f),
        new ActPhase("shut", 0.22f, ActEase.Out).To(Jaw, 0.1f).To(Reach, 1f).To(Ears, 1f).To(Lids, 0.6f).Then(ActMark.Contact),
        wrench.To(Reach, 0.75f).To(Ahead, -0.05f).With(new ActWave(NeckSide, 0.2f, 1.5f, -0.1f)).With(new ActWave(TailSide, 0.4f, 1.5f, 0.3f)),
        new ActPhase("recover", 2.0f).To(Reach, 0f).To(Ahead, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(Jaw, 0f).To(Lids, 0f).To(Ears, 0f).To(TailPitch, 0f).To(ArmsAhead, 0f))
        .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.15f);

    /// <summary>An arm drawn back with its shoulder, and struck out: the trunk winds up and lets go, and the tail goes against it.</summary>
    /// <param name="turn">How far the trunk turns over its feet: four leave it less room than two.</param>
    private static Act ClawOfArms(float turn) => new Act("Claw", ActKind.Strike,
        new ActPhase("raise", 1.9f).To(Ahead, -0.08f * turn).To(HindDown, 0.1f * turn).To(ArmAhead, 0.5f).To(ArmOut, 1.1f).To(ArmBend, 1.2f).To(ArmsOut, 0.2f).To(BackTwist, 0.25f * turn).To(BackSide, -0.2f * turn).To(Yaw, 0.25f * turn).To(NeckSide, -0.2f).To(TailSide, -0.4f).To(Jaw, 0.5f).To(Ears, 0.6f).AtLeast(Seen).Then(ActMark.Commit),
        new ActPhase("strike", 0.75f, ActEase.In).To(Ahead, 0.12f).To(HindDown, 0.02f * turn).To(ArmAhead, 0.9f).To(ArmOut, 0.3f).To(ArmBend, 0.2f).To(ArmsOut, 0f).To(BackTwist, -0.2f * turn).To(Yaw, -0.2f * turn).To(NeckSide, 0.15f).To(TailSide, 0.4f).To(Jaw, 0.8f).To(Reach, 0.85f),
        new ActPhase("hit", 0.3f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
        new ActPhase("tear", 0.9f, ActEase.Out).To(Reach, 0f).To(ArmAhead, 0.3f).To(ArmOut, -0.3f).To(ArmBend, 0.5f).To(BackSide, 0.1f * turn).To(Yaw, -0.28f * turn).To(HindDown, 0.12f * turn),
        new ActPhase("recover", 1.8f).To(Ahead, 0f).To(HindDown, 0f).To(ArmAhead, 0f).To(ArmOut, 0f).To(ArmBend, 0f).To(BackTwist, 0f).To(BackSide, 0f).To(Yaw, 0f).To(NeckSide, 0f).To(TailSide, 0f).To(Jaw, 0f).To(Ears, 0f))
        .With(ActTool.Hand);

    /// <summary>As scorpions do: the tail rolled up over a body that crouches, and struck out ahead.</summary>
    private static Act OverBack() => new Act("Sting", ActKind.Strike,
        new ActPhase("cock", 3.5f).To(TailPitch, 1.1f).To(TailCurl, 1.2f).To(HindDown, -0.15f).To(ForeDown, 0.35f).To(Ahead, -0.08f).To(NeckPitch, -0.15f).To(HeadPitch, 0.1f).To(Jaw, 0.3f).To(Ears, 0.8f).AtLeast(Seen).Then(ActMark.Commit),
        new ActPhase("strike", 0.55f, ActEase.In).To(Ahead, 0.1f).To(TailPitch, 2f).To(TailCurl, 0.4f).To(Reach, 0.85f),
        new ActPhase("hit", 0.2f, ActEase.Out).To(Reach, 1f).Then(ActMark.Contact),
        new ActPhase("hold", 0.5f),
        new ActPhase("draw back", 3f).To(Reach, 0f).To(TailPitch, 1.1f).To(TailCurl, 0.9f).To(Ahead, 0f),
        new ActPhase("recover", 2.4f).To(TailPitch, 0f).To(TailCurl, 0f).To(HindDown, 0f).To(ForeDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Jaw, 0f).To(Ears, 0f))
        .With(ActTool.Tail).OnTheSpot();
}
