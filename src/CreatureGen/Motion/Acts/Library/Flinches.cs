using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>How bodies flinch: those without a face to show it give more with the rest.</summary>
internal static class Flinches
{
    /// <summary>A low body springs back over its feet and arches: chest down, head tucked in, abdomen or tail up.</summary>
    public static readonly Act OfManyLegs = Of(
        new ActPhase("start", 0.9f, ActEase.Out).To(Ahead, -0.42f).To(Yaw, 0.12f).To(ForeDown, 0.55f).To(HindDown, 0.15f).To(BackSide, 0.2f).To(NeckPitch, -0.3f).To(HeadPitch, -0.6f).To(NeckSide, -0.5f).To(HeadSide, -0.3f).To(Ears, 1f).To(Lids, 1f).To(TailPitch, 0.7f).To(TailCurl, 0.8f).To(ArmsBend, 1f).To(ArmsAhead, 0.7f).To(Wings, 0.6f),
        new ActPhase("freeze", 1.8f).To(Ahead, -0.34f).To(TailCurl, 0.6f).With(new ActWave(Up, 0.006f, 6f)).With(new ActWave(TailSide, 0.1f, 4f)),
        new ActPhase("look", 1.4f).To(Lids, -0.2f).To(HeadPitch, 0f).To(HeadSide, 0.2f).To(Ears, -0.4f))
        .For(BodyBuild.ManyLegged);

    /// <summary>A body on two legs leans away over bent knees, arms and wings up before it.</summary>
    public static readonly Act OfTwoLegs = Of(
        new ActPhase("start", 0.6f, ActEase.Out).To(Ahead, -0.22f).To(Pitch, 0.2f).To(Yaw, 0.1f).To(ForeDown, 0.4f).To(HindDown, 0.4f).To(BackSide, -0.15f).To(NeckPitch, 0.35f).To(HeadPitch, -0.55f).To(NeckSide, -0.7f).To(HeadSide, -0.35f).To(Lids, 1f).To(Ears, 1f).To(TailPitch, -0.6f).To(ArmsBend, 1.4f).To(ArmsAhead, 0.9f).To(Wings, 0.6f),
        new ActPhase("freeze", 1.6f).To(Ahead, -0.18f).To(Pitch, 0.12f).With(new ActWave(Up, 0.006f, 6f)),
        new ActPhase("look", 1.4f).To(Lids, -0.2f).To(NeckSide, -0.3f).To(HeadSide, 0.15f).To(HeadPitch, -0.2f))
        .For(BodyBuild.TwoLegged | BodyBuild.Upright);

    /// <summary>In water a body bends into a C, head and tail away from what startled it, is back with a stroke of the tail, and hangs there with its fins spread.</summary>
    public static readonly Act OfSwimmers = Of(
        new ActPhase("bend", 0.6f, ActEase.Out).To(Yaw, -0.35f).To(Roll, 0.25f).To(Ahead, -0.3f).To(BackSide, -0.8f).To(NeckSide, -0.5f).To(HeadSide, -0.2f).To(Jaw, 0.4f).To(Lids, 1f).To(Ears, 1f).To(Wings, 0.9f),
        new ActPhase("stroke", 0.7f, ActEase.Out).To(Yaw, -0.15f).To(Ahead, -1f).To(BackSide, 0.35f).To(NeckSide, 0.1f).To(Jaw, 0.1f),
        new ActPhase("freeze", 2.4f).To(Roll, 0.1f).To(BackSide, -0.12f).To(NeckSide, -0.2f).To(Lids, -0.2f).To(Wings, 0.7f).With(new ActWave(Wings, 0.15f, 6f)))
        .For(BodyBuild.Swimming);

    /// <summary>On the wing a body starts up and back, banks away, its abdomen under it, and hovers there.</summary>
    public static readonly Act OfFliers = Of(
        new ActPhase("start", 1.2f, ActEase.Out).To(Ahead, -0.9f).To(Up, 0.7f).To(Pitch, 0.5f).To(Yaw, -0.3f).To(Roll, 0.5f).To(BackPitch, -0.3f).To(NeckSide, -0.6f).To(HeadSide, -0.25f).To(HeadPitch, -0.3f).To(Lids, 1f).To(Ears, 1f).To(TailPitch, -0.9f),
        new ActPhase("hang", 2.4f).To(Ahead, -0.7f).To(Up, 0.4f).To(Pitch, 0.15f).To(Roll, 0.1f).To(Lids, -0.2f).To(TailPitch, -0.5f).With(new ActWave(Aside, 0.15f, 2f)).With(new ActWave(Roll, 0.12f, 2f)))
        .For(BodyBuild.Airborne);

    /// <summary>A crawler draws its head up and back over its coils, away from what startled it: laid along the ground it could not strike.</summary>
    public static readonly Act OfCrawlers = Of(
        new ActPhase("start", 0.6f, ActEase.Out).To(NeckPitch, 0.95f).To(HeadPitch, -0.7f).To(NeckSide, -0.9f).To(HeadSide, -0.2f).To(HeadRoll, -0.2f).To(Lids, 1f).To(Ears, 1f).To(TailSide, 1f).To(Jaw, 0.35f),
        new ActPhase("freeze", 2.4f).To(NeckPitch, 0.8f).To(NeckSide, -0.6f).To(HeadSide, 0.45f).To(HeadRoll, 0f).To(Lids, -0.2f).To(Jaw, 0f).With(new ActWave(NeckSide, 0.03f, 6f)))
        .For(BodyBuild.Legless);

    /// <summary>Pillars hardly fold: a body on them throws up its head and its tail, ears spread, and leans back from what startled it.</summary>
    public static readonly Act OfPillars = Of(
        new ActPhase("start", 0.8f, ActEase.Out).To(Ahead, -0.3f).To(Yaw, 0.1f).To(BackSide, -0.1f).To(ForeDown, 0.1f).To(HindDown, 0.28f).To(NeckPitch, 0.9f).To(HeadPitch, -0.3f).To(NeckSide, -0.8f).To(HeadSide, -0.3f).To(HeadRoll, -0.2f).To(Lids, 1f).To(Ears, -1f).To(TailPitch, 1.1f).To(TailSide, 0.5f).To(Jaw, 0.4f).To(ArmsBend, 1f).To(ArmsAhead, 0.7f).To(Wings, 0.6f),
        new ActPhase("freeze", 2f).To(Ahead, -0.24f).To(Lids, -0.2f).To(HeadSide, 0.2f).To(Jaw, 0.1f).With(new ActWave(Up, 0.006f, 6f)).With(new ActWave(TailSide, 0.25f, 3f)).With(new ActWave(Ears, 0.3f, 3f)))
        .For(BodyBuild.Columnar);

    public static readonly Act OfOthers = Of(
        new ActPhase("start", 0.6f, ActEase.Out).To(Ahead, -0.18f).To(ForeDown, 0.28f).To(HindDown, 0.2f).To(NeckPitch, 0.5f).To(HeadPitch, -0.45f).To(NeckSide, -0.6f).To(HeadSide, -0.25f).To(BackSide, -0.08f).To(Lids, 1f).To(Ears, 1f).To(TailPitch, -1f).To(ArmsBend, 1f).To(ArmsAhead, 0.7f).To(Wings, 0.5f),
        new ActPhase("freeze", 1.6f).To(Lids, -0.2f).To(HeadSide, 0.1f).With(new ActWave(Up, 0.006f, 6f)));

    /// <summary>All that started, and eases again.</summary>
    internal static Act Of(params ActPhase[] started)
    {
        ActPhase ease = new ActPhase("ease", 2.6f).To(FrontUp, 0f).To(FrontSide, 0f).To(ForeFeetUp, 0f).To(ForeFeetOut, 0f).To(Ahead, 0f).To(Up, 0f).To(Pitch, 0f).To(Yaw, 0f).To(Roll, 0f).To(BackPitch, 0f).To(Jaw, 0f).To(TailSide, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(BackSide, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(HeadRoll, 0f)
            .To(Lids, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(ArmsBend, 0f).To(ArmsAhead, 0f).To(Wings, 0f);
        return new Act("Flinch", ActKind.Reflex, [.. started, ease]);
    }
}
