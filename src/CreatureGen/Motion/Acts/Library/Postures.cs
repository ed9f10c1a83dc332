using System.Collections.Generic;
using CreatureGen.Motion.Acts.Data;
using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>Acts that last until the creature is told to go on: sitting, lying, sleeping, and the last.</summary>
internal static class Postures
{
    private static readonly ActPhase[] lie =
    {
        new ActPhase("lie", 10f).To(NeckPitch, 0.08f).To(Lids, 0.1f).Lasting().With(new ActWave(Up, 0.004f, 3f)).With(new ActWave(HeadSide, 0.12f, 1f)).With(new ActWave(TailSide, 0.1f, 0.5f)),
    };

    private static readonly ActPhase[] propped =
    {
        new ActPhase("lie", 10f).To(NeckPitch, 0.6f).To(Lids, 0.1f).Lasting().With(new ActWave(Up, 0.004f, 3f)).With(new ActWave(HeadSide, 0.12f, 1f)).With(new ActWave(TailSide, 0.1f, 0.5f)),
    };

    private static readonly ActPhase[] sleep = SleepBy(new ActPhase("nod", 3.5f).To(NeckPitch, -0.9f).To(HeadPitch, 0.45f).To(NeckSide, 0.35f).To(HeadSide, 0.1f).To(TailSide, 0.5f));

    // Low on the ground: the chin is laid on it.
    private static readonly ActPhase[] sleepOnChin = SleepBy(new ActPhase("nod", 3.5f).To(NeckPitch, -0.9f).To(HeadPitch, 1f).To(NeckSide, 0.35f).To(HeadSide, 0.1f).To(TailSide, 0.5f));

    // The same with the legs out beside it: bent round, head and tail to the same side.
    private static readonly ActPhase[] sleepRound = SleepBy(new ActPhase("curl up", 3.5f).To(BackSide, 0.4f).To(Yaw, -0.15f).To(NeckPitch, -0.9f).To(NeckSide, 0.8f).To(HeadPitch, 0.8f).To(HeadSide, 0.3f).To(TailSide, 1.2f));

    // Curled up on the belly: head and tail round to a flank.
    private static readonly ActPhase[] sleepCurled = SleepBy(new ActPhase("curl up", 3.5f).To(BackSide, 0.25f).To(NeckPitch, -0.7f).To(NeckSide, 1.3f).To(HeadPitch, 0.2f).To(HeadSide, 0.5f).To(TailSide, 1f));

    // On many legs: bent round to a side until the head lies by the tail.
    private static readonly ActPhase[] sleepCoiled =
    {
        new ActPhase("bend", 4f).To(Yaw, -0.5f).To(BackSide, 1.1f).To(NeckSide, 0.5f).To(NeckPitch, -0.4f).To(TailSide, 0.6f).To(Lids, 0.5f),
        new ActPhase("coil up", 4f).To(Yaw, -1f).To(BackSide, 2.2f).To(NeckSide, 1f).To(NeckPitch, -0.8f).To(HeadPitch, 0.6f).To(HeadSide, 0.4f).To(TailSide, 1.2f).To(Lids, 1f).To(Ears, 0.35f),
        new ActPhase("sleep", 14f).Lasting().With(new ActWave(BackSide, 0.02f, 2.5f)),
        new ActPhase("wake", 1.6f).To(Lids, 0.2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ears, -0.3f),
        new ActPhase("uncoil", 4f).To(Yaw, 0f).To(BackSide, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(TailSide, 0f),
    };

    // The same at rest: bent, the front a little off the ground, it looks about.
    private static readonly ActPhase[] lieInBend =
    {
        new ActPhase("bend", 3f).To(Yaw, -0.35f).To(BackSide, 0.9f).To(TailSide, 0.8f).To(FrontUp, 0.15f).To(FrontSide, -0.3f),
        new ActPhase("lie", 10f).To(FrontUp, 0.22f).To(Lids, 0.1f).Lasting().With(new ActWave(FrontSide, 0.15f, 1f)).With(new ActWave(NeckSide, 0.3f, 1f, 0.1f)).With(new ActWave(Ears, 0.3f, 2f)).With(new ActWave(TailSide, 0.25f, 1f)),
        new ActPhase("straighten", 3f).To(FrontUp, 0f).To(FrontSide, 0f).To(Yaw, 0f).To(BackSide, 0f).To(TailSide, 0f),
    };

    // On two legs, as birds do: the head turned away and laid on a shoulder.
    private static readonly ActPhase[] sleepTucked = SleepBy(new ActPhase("tuck", 3.5f).To(NeckPitch, -0.5f).To(NeckSide, 1.4f).To(HeadPitch, -0.45f).To(HeadSide, 0.5f).To(TailSide, 0.3f));

    // Over onto the flank out of lying, and back onto the belly.
    private static readonly ActPhase[] sleepOnFlank =
    {
        OntoFlank("roll over", 3.5f, ActEase.Smooth).To(NeckSide, 0.7f).To(HeadSide, 0.2f).To(NeckPitch, -0.1f).To(TailSide, 0.7f).To(ArmsAhead, 0.3f).To(ArmsOut, -0.4f).To(ArmsBend, 0.4f).To(Lids, 0.8f).To(Ears, 0.35f),
        new ActPhase("nod", 1.6f).To(NeckSide, 0.9f).To(Lids, 1f),
        new ActPhase("sleep", 14f).Lasting().With(new ActWave(BackPitch, 0.012f, 2.5f)),
        new ActPhase("wake", 1.6f).To(Lids, 0.2f).To(NeckSide, 0.1f).To(NeckPitch, 0.1f).To(Ears, -0.3f),
        new ActPhase("roll back", 3f).To(OnFlank, 0f).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(ForeFeetPitch, 0f).To(HindFeetPitch, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(TailSide, 0f).To(ArmsAhead, 0f).To(ArmsOut, 0f).To(ArmsBend, 0f).To(Lids, 0f),
    };

    // Of an upright body, on its side.
    private static readonly ActPhase[] sleepOnSide =
    {
        new ActPhase("nod", 3.5f).To(NeckPitch, -0.4f).To(NeckSide, 0.7f).To(HeadSide, 0.2f).To(TailSide, 0.5f).To(Lids, 1f).To(Ears, 0.35f),
        new ActPhase("sleep", 14f).Lasting().With(new ActWave(BackPitch, 0.012f, 2.5f)),
        new ActPhase("wake", 1.6f).To(Lids, 0.2f).To(NeckSide, 0.1f).To(NeckPitch, 0.1f).To(Ears, -0.3f),
    };

    private static readonly ActPhase[] recline =
    {
        new ActPhase("recline", 2f).To(NeckPitch, 0.1f).To(NeckSide, -0.9f).To(HeadSide, -0.2f).To(TailSide, 0.4f),
        new ActPhase("lie", 10f).To(Lids, 0.1f).Lasting().With(new ActWave(BackPitch, 0.008f, 2.5f)).With(new ActWave(NeckPitch, 0.12f, 1f)).With(new ActWave(HeadPitch, 0.12f, 1f, 0.1f)).With(new ActWave(TailPitch, 0.12f, 1f)),
    };

    public static readonly Act[] All =
    {
        new Act("Sit", ActKind.Posture,
            new ActPhase("lower", 1.6f).To(HindDown, 0.4f).To(HindFold, 0.3f).To(NeckPitch, 0.1f),
            new ActPhase("settle", 2f).To(HindDown, 0.97f).To(HindFold, 1f).To(BackPitch, 0.1f).To(NeckPitch, 0f).To(TailPitch, 0.9f),
            new ActPhase("sit", 10f).To(Ears, -0.2f).Lasting().With(new ActWave(Up, 0.004f, 3f)).With(new ActWave(TailSide, 0.25f, 1f)),
            new ActPhase("rise", 1.6f).To(HindDown, 0.4f).To(HindFold, 0.3f).To(BackPitch, 0f).To(TailPitch, 0.3f),
            new ActPhase("stand", 1.6f).To(HindDown, 0f).To(HindFold, 0f).To(TailPitch, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Legs).For(BodyBuild.Pawed | BodyBuild.Upright).OnTheSpot(),
        Lying("Lie", GettingDownOnPaws(lie)).For(BodyBuild.Pawed),
        Lying("Lie", GettingDownOnHooves(lie)).For(BodyBuild.Hoofed | BodyBuild.Columnar),
        Lying("Lie", GettingDownSideways(recline)).Needing(ActNeeds.Legs | ActNeeds.Flanks).For(BodyBuild.Upright),
        Lying("Lie", GettingDownUpright(propped)).For(BodyBuild.Upright),
        Lying("Lie", GettingDown(lieInBend)).Needing(ActNeeds.Legs | ActNeeds.Front).For(BodyBuild.ManyLegged),
        Lying("Lie", GettingDown(lie)).For(BodyBuild.Standing),
        Lying("Sleep", GettingDownOnPaws(sleepOnFlank)).Needing(ActNeeds.FourLegs | ActNeeds.BareFlanks).For(BodyBuild.Pawed),
        Lying("Sleep", GettingDownOnHooves(sleepOnFlank)).Needing(ActNeeds.FourLegs | ActNeeds.BareFlanks).For(BodyBuild.Hoofed | BodyBuild.Columnar),
        Lying("Sleep", GettingDownOnPaws(sleepCurled)).For(BodyBuild.Pawed),
        Lying("Sleep", GettingDownOnHooves(sleepCurled)).For(BodyBuild.Hoofed | BodyBuild.Columnar),
        Lying("Sleep", GettingDownSideways(sleepOnSide)).Needing(ActNeeds.Legs | ActNeeds.Flanks).For(BodyBuild.Upright),
        Lying("Sleep", GettingDownUpright(sleep)).For(BodyBuild.Upright),
        Lying("Sleep", GettingDown(sleepTucked)).For(BodyBuild.TwoLegged),
        Lying("Sleep", GettingDown(sleepCoiled)).Needing(ActNeeds.Legs | ActNeeds.Front).For(BodyBuild.ManyLegged),
        Lying("Sleep", GettingDown(sleepRound)).For(BodyBuild.Sprawling),
        Lying("Sleep", GettingDown(sleepOnChin)).For(BodyBuild.Standing),
        new Act("Sleep", ActKind.Posture,
            new ActPhase("nod", 4f).To(ForeDown, 1f).To(NeckSide, 0.4f).To(Lids, 1f),
            new ActPhase("sleep", 14f).Lasting().With(new ActWave(BackPitch, 0.01f, 2.5f)),
            new ActPhase("wake", 2.4f).To(ForeDown, 0f).To(NeckSide, 0f).To(Lids, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Legless),
        new Act("Sleep", ActKind.Posture,
            new ActPhase("sink", 5f).To(Up, -0.4f).To(Pitch, -0.3f).To(Roll, 0.3f).To(BackPitch, -0.2f).To(BackSide, 0.12f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(Wings, -0.7f).To(Lids, 1f),
            new ActPhase("sleep", 14f).Lasting().With(new ActWave(Up, 0.12f, 2f)).With(new ActWave(Roll, 0.1f, 1f)).With(new ActWave(Pitch, 0.04f, 2f, 0.2f)).With(new ActWave(Wings, 0.1f, 2f, 0.3f)),
            new ActPhase("stretch", 2.4f).To(Up, 0f).To(Pitch, 0.1f).To(Roll, 0f).To(BackPitch, 0.15f).To(BackSide, -0.15f).To(NeckPitch, 0.1f).To(HeadPitch, 0f).To(Wings, 0.5f).To(Lids, 0f),
            new ActPhase("level", 2.4f).To(Pitch, 0f).To(BackPitch, 0f).To(BackSide, 0f).To(NeckPitch, 0f).To(Wings, 0f))
            .For(BodyBuild.Swimming),
        new Act("Sleep", ActKind.Posture,
            new ActPhase("nod", 5f).To(Up, -0.5f).To(Pitch, 0.2f).To(BackPitch, -0.25f).To(NeckPitch, -0.8f).To(NeckSide, 0.2f).To(HeadPitch, -0.4f).To(TailPitch, -0.6f).To(Lids, 1f).To(Ears, 0.4f),
            new ActPhase("sleep", 14f).Lasting().With(new ActWave(Up, 0.25f, 1.5f)).With(new ActWave(Roll, 0.12f, 1f)).With(new ActWave(Pitch, 0.06f, 1.5f, 0.2f)).With(new ActWave(TailPitch, 0.12f, 1.5f, 0.4f)),
            new ActPhase("wake", 3f).To(Up, 0f).To(Pitch, 0f).To(BackPitch, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(TailPitch, 0f).To(Lids, 0f).To(Ears, 0f))
            .For(BodyBuild.Airborne),
        new Act("Sleep", ActKind.Posture,
            new ActPhase("nod", 4f).To(Lids, 1f).To(NeckPitch, -0.1f).To(Wings, -0.2f),
            new ActPhase("sleep", 14f).Lasting().With(new ActWave(Up, 0.02f, 2.5f)).With(new ActWave(Roll, 0.03f, 1f)),
            new ActPhase("wake", 2.4f).To(Lids, 0f).To(NeckPitch, 0f).To(Wings, 0f)),
        Dying([
            new ActPhase("reel", 1.6f).To(Aside, 0.06f).To(Roll, -0.06f).To(NeckPitch, 0.3f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.4f).To(Ears, 0.8f).To(ArmsOut, 0.4f),
            new ActPhase("buckle", 1.4f, ActEase.In).To(HindDown, 0.6f).To(HindFold, 0.4f).To(Aside, 0f).To(NeckPitch, -0.2f).To(ArmsAhead, 0.3f).To(ArmsOut, 0.1f),
            new ActPhase("topple", 1.8f, ActEase.In).To(HindDown, 0.5f).To(HindFold, 0f).To(ForeFold, 1f).To(OnFlank, 0.8f).To(NeckPitch, 0.1f).To(NeckSide, -0.5f).To(Roll, 0f).To(ArmsAhead, 0.1f).To(ArmsOut, -0.45f).To(ArmOut, 0.25f),
            new ActPhase("drop", 1f, ActEase.Out).To(HindDown, 0.35f).To(OnFlank, 1f).To(NeckSide, -0.1f).To(TailSide, 0.6f).To(Jaw, 0.3f),
            new ActPhase("settle", 2.4f).To(HindDown, 0.25f).To(NeckPitch, -0.2f).To(NeckSide, 0.7f).To(HeadSide, 0.2f).To(Lids, 0.8f),
            new ActPhase("still", 5f).Lasting(),
            .. GettingUpSideways()])
            .Needing(ActNeeds.Legs | ActNeeds.Flanks).For(BodyBuild.Upright).OnTheSpot(),
        Dying(
            new ActPhase("reel", 1.6f).To(Aside, 0.06f).To(Roll, -0.06f).To(NeckPitch, 0.3f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.4f).To(Ears, 0.8f).To(ArmsOut, 0.4f),
            new ActPhase("buckle", 1.4f, ActEase.In).To(HindDown, 0.5f).To(HindFold, 0.4f).To(Aside, 0f).To(NeckPitch, -0.2f).To(ArmsAhead, 0.4f),
            new ActPhase("topple", 1.3f, ActEase.In).To(HindDown, 0.62f).To(HindFold, 0.2f).To(ForeFold, 0.5f).To(NeckPitch, 0.2f).To(Roll, 0f).To(ArmsAhead, 1f),
            new ActPhase("drop", 0.9f, ActEase.Out).To(HindDown, 1f).To(HindFold, 0f).To(ForeFold, 1f).To(ArmsAhead, 1.3f),
            new ActPhase("settle", 1.6f, ActEase.Out).To(NeckPitch, -0.5f).To(NeckSide, 0.5f).To(HeadRoll, 0.25f).To(HeadSide, 0.2f).To(Lids, 0.8f).To(Jaw, 0.3f).To(TailSide, 0.4f).To(TailPitch, -0.8f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("push", 2.6f).To(ForeFold, 0.45f).To(HindFold, 0.3f).To(HindDown, 0.62f).To(NeckPitch, 0.2f).To(NeckSide, 0f).To(HeadRoll, 0f).To(HeadSide, 0f),
            new ActPhase("squat", 2.2f).To(ForeFold, 0f).To(HindFold, 0.6f).To(HindDown, 0.6f).To(ArmsAhead, 0.3f).To(NeckPitch, 0f).To(Lids, 0f).To(Jaw, 0f),
            new ActPhase("rise", 2.2f).To(HindDown, 0f).To(HindFold, 0f).To(ArmsAhead, 0f).To(ArmsOut, 0f).To(Ears, 0f).To(TailSide, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Legs).For(BodyBuild.Upright).OnTheSpot(),
        Dying(
            new ActPhase("reel", 1.6f).To(Aside, 0.06f).To(Roll, -0.06f).To(NeckPitch, 0.3f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.4f).To(Ears, 0.8f),
            new ActPhase("buckle", 1.2f, ActEase.In).To(ForeDown, 0.62f).To(HindDown, 0.45f).To(ForeFold, 0.6f).To(HindFold, 0.4f).To(Aside, 0f).To(NeckPitch, -0.1f),
            new ActPhase("drop", 1.4f, ActEase.In).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, -0.1f).To(NeckSide, 0.2f).To(ArmsAhead, 0.5f).To(Roll, 0f).To(OnFlank, 0.1f),
            new ActPhase("topple", 1.8f, ActEase.In).To(OnFlank, 0.7f).To(NeckSide, 0.9f).To(NeckPitch, 0.1f).To(HeadSide, 0.3f).To(TailSide, 0.9f).To(Jaw, 0.3f),
            new ActPhase("drop on the flank", 1.35f, ActEase.Out).To(OnFlank, 1f),
            OntoFlank("stretch", 1.8f, ActEase.Smooth).To(NeckPitch, -0.1f).To(Lids, 0.8f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("draw in", 1.4f).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(ForeFeetPitch, 0f).To(HindFeetPitch, 0f).To(NeckSide, 0.4f),
            new ActPhase("gather", 2.2f).To(OnFlank, 0.1f).To(ForeDown, 0.9f).To(HindDown, 0.97f).To(ForeFold, 0.9f).To(HindFold, 1f).To(NeckPitch, 0f).To(NeckSide, -0.1f).To(HeadSide, 0f).To(TailSide, 0.2f),
            new ActPhase("lift", 2.4f).To(OnFlank, 0f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.4f).To(HindFold, 0.4f).To(NeckPitch, -0.2f).To(NeckSide, 0f).To(TailSide, 0f).To(ArmsAhead, 0f),
            new ActPhase("rise", 2.6f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(Lids, 0f).To(Jaw, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Legs | ActNeeds.Flanks).For(BodyBuild.Pawed | BodyBuild.Hoofed | BodyBuild.Columnar | BodyBuild.TwoLegged | BodyBuild.ManyLegged).OnTheSpot(),
        Dying(
            new ActPhase("stagger", 1.4f).To(NeckPitch, 0.35f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.5f).To(Ears, 0.8f).To(TailPitch, 0.2f),
            new ActPhase("give way", 1.1f, ActEase.In).To(ForeDown, 0.6f).To(ForeFold, 0.55f).To(HindDown, 0.5f).To(HindFold, 0.4f).To(NeckPitch, 0.1f).To(NeckSide, 0.2f).To(TailPitch, 0f),
            new ActPhase("tip", 2f).To(ForeDown, LyingSide.DownAsItTurns).To(HindDown, LyingSide.DownAsItTurns).To(ForeFold, 1f).To(HindFold, 1f).To(OnFlank, 0.08f).To(NeckPitch, 0f),
            new ActPhase("turn over", 1.9f, ActEase.In).To(OnFlank, 0.65f).To(ArmsAhead, 0.5f),
            new ActPhase("drop", 1.2f, ActEase.Out).To(OnFlank, 1f).To(Jaw, 0.35f).To(Ears, 0.3f),
            new ActPhase("curl up", 2.4f).To(Up, 0.12f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(ForeFeetPitch, 0.5f).To(HindFeetPitch, 0.5f).To(NeckSide, 0.4f).To(HeadSide, 0.2f).To(TailSide, 0.4f).To(Lids, 0.8f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("draw in", 1.6f).To(Up, 0f).To(ForeDown, LyingSide.DownAsItTurns).To(HindDown, LyingSide.DownAsItTurns).To(ForeFold, 1f).To(HindFold, 1f).To(ForeFeetPitch, 0f).To(HindFeetPitch, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(TailSide, 0f),
            new ActPhase("turn back", 3f).To(OnFlank, 0.08f),
            new ActPhase("gather", 2f).To(OnFlank, 0f),
            new ActPhase("lift", 1.8f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.4f).To(HindFold, 0.4f).To(ArmsAhead, 0f),
            new ActPhase("rise", 2.2f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(Lids, 0f).To(Jaw, 0f).To(Ears, 0f))
            .Needing(ActNeeds.FourLegs | ActNeeds.Back).For(BodyBuild.Sprawling | BodyBuild.ManyLegged).OnTheSpot(),
        Dying(
            new ActPhase("rear", 1.4f).To(FrontUp, 0.5f).To(FrontSide, -0.3f).To(ForeFeetUp, 0.15f).To(NeckPitch, 0.3f).To(Lids, 0.5f).To(Jaw, 0.5f).To(Ears, 0.8f).To(TailPitch, 0.3f),
            new ActPhase("give way", 1.4f, ActEase.In).To(FrontUp, 0f).To(FrontSide, 0f).To(ForeFeetUp, 0f).To(ForeDown, 0.9f).To(ForeFold, 0.9f).To(HindDown, 0.8f).To(HindFold, 0.8f).To(NeckPitch, -0.2f).To(TailPitch, 0f),
            new ActPhase("writhe", 2f).To(ForeDown, 1f).To(HindDown, 1f).To(ForeFold, 1f).To(HindFold, 1f).To(Yaw, 0.4f).To(BackSide, -0.8f).To(NeckSide, -0.5f).To(TailSide, -0.8f),
            new ActPhase("writhe back", 2.4f).To(Yaw, -0.7f).To(BackSide, 1.4f).To(NeckSide, 0.7f).To(NeckPitch, -0.9f).To(HeadPitch, 0.6f).To(HeadRoll, 0.5f).To(HeadSide, 0.3f).To(TailSide, 1f),
            new ActPhase("slacken", 2.4f, ActEase.Out).To(Yaw, -0.5f).To(BackSide, 1.1f).To(Roll, 0.12f).To(TailPitch, -1f).To(ForeFeetOut, 0.15f).To(ForeFootAhead, 0.25f).To(HindFeetAhead, -0.3f).To(Lids, 0.8f).To(Jaw, 0.15f).To(Wings, 0.2f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("gather", 3f).To(ForeFeetOut, 0f).To(ForeFootAhead, 0f).To(HindFeetAhead, 0f).To(Yaw, 0f).To(BackSide, 0f).To(Roll, 0f).To(NeckPitch, -0.1f).To(NeckSide, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(TailSide, 0f).To(Wings, 0f),
            new ActPhase("lift", 1.8f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.4f).To(HindFold, 0.4f),
            new ActPhase("rise", 2.2f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(Lids, 0f).To(Jaw, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.FourLegs | ActNeeds.Front).For(BodyBuild.ManyLegged).OnTheSpot(),
        Dying(
            new ActPhase("stagger", 1.4f).To(NeckPitch, 0.35f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.5f).To(Ears, 0.8f).To(TailPitch, 0.2f),
            new ActPhase("give way", 1.1f, ActEase.In).To(ForeDown, 0.52f).To(ForeFold, 0.55f).To(HindDown, 0.46f).To(HindFold, 0.4f).To(NeckPitch, 0.2f).To(NeckSide, 0f).To(TailPitch, 0f),
            new ActPhase("drop", 1.2f, ActEase.In).To(ForeDown, 1f).To(HindDown, 1f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, -0.5f).To(TailPitch, -0.3f),
            new ActPhase("slump", 1.8f, ActEase.Out).To(ForeFold, 0.85f).To(HindFold, 0.85f).To(ForeFeetOut, 0.2f).To(ForeFootAhead, 0.3f).To(HindFeetAhead, -0.4f).To(HindFootAhead, 0.25f).To(NeckPitch, -0.9f).To(NeckSide, 0.8f).To(HeadPitch, 0.6f).To(HeadRoll, 0.6f).To(HeadSide, 0.3f)
                .To(Roll, 0.18f).To(BackSide, 0.35f).To(TailSide, 1f).To(TailPitch, -1.2f).To(Lids, 0.8f).To(Jaw, 0.1f).To(ArmsOut, 0.3f).To(Wings, 0.2f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("gather", 2f).To(ForeFeetOut, 0f).To(ForeFootAhead, 0f).To(HindFeetAhead, 0f).To(HindFootAhead, 0f).To(Roll, 0f).To(BackSide, 0f).To(NeckPitch, -0.1f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(Wings, 0f),
            new ActPhase("lift", 1.8f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.4f).To(HindFold, 0.4f).To(NeckSide, 0f).To(HeadSide, 0f).To(TailSide, 0f),
            new ActPhase("rise", 2.2f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(Lids, 0f).To(Jaw, 0f).To(Ears, 0f).To(TailPitch, 0f).To(ArmsOut, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.Sprawling | BodyBuild.ManyLegged).OnTheSpot(),
        DyingOnBelly(-0.6f).For(BodyBuild.TwoLegged),
        DyingOnBelly(0f).For(BodyBuild.Standing),
        Dying(
            new ActPhase("jerk", 1f, ActEase.Out).To(BackSide, 0.5f).To(TailSide, 0.8f).To(NeckSide, 0.5f).To(Jaw, 0.6f).To(NeckPitch, 0.5f).To(Wings, 0.6f),
            new ActPhase("twitch", 1.2f).To(BackSide, -0.3f).To(TailSide, -0.7f).To(NeckSide, -0.2f).To(NeckPitch, 0.1f).To(Roll, 0.5f).To(Wings, -0.2f),
            new ActPhase("roll", 5f).To(BackSide, 0.15f).To(BackPitch, 0.15f).To(TailSide, 0.2f).To(TailPitch, 0.3f).To(NeckSide, 0.2f).To(Roll, 2.8f).To(Up, 0.3f).To(Lids, 0.8f).To(Jaw, 0.35f).To(Wings, 0.4f),
            new ActPhase("still", 5f).Lasting().With(new ActWave(Up, 0.05f, 1f)).With(new ActWave(Roll, 0.06f, 1f, 0.3f)),
            new ActPhase("rise", 4f).To(Up, 0f).To(BackSide, 0f).To(BackPitch, 0f).To(TailSide, 0f).To(TailPitch, 0f).To(NeckSide, 0f).To(NeckPitch, 0f).To(Roll, 0f).To(Lids, 0f).To(Jaw, 0f).To(Wings, 0f))
            .For(BodyBuild.Swimming),
        Dying(
            new ActPhase("fall", 12f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("rise", 8f))
            .For(BodyBuild.Airborne),
        Dying(
            new ActPhase("reel", 2f).To(NeckPitch, 0.7f).To(HeadPitch, -0.3f).To(NeckSide, 0.4f).To(Jaw, 0.7f),
            new ActPhase("sag", 1.6f).To(ForeDown, 0.45f).To(NeckPitch, 0.2f).To(HeadPitch, 0f).To(NeckSide, -0.2f).To(Lids, 0.4f),
            new ActPhase("drop", 1.2f, ActEase.In).To(ForeDown, 1f).To(NeckPitch, -0.2f).To(NeckSide, -0.5f),
            new ActPhase("turn over", 2f).To(HeadRoll, 0.6f).To(NeckTwist, 0.4f).To(Jaw, 0.5f).To(Lids, 0.7f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("rise", 3f).To(ForeDown, 0f).To(NeckPitch, 0f).To(HeadRoll, 0f).To(NeckTwist, 0f).To(NeckSide, 0f).To(Jaw, 0f).To(Lids, 0f))
            .For(BodyBuild.Legless),
    };

    /// <summary>Down on the belly, the head laid to a side; who stands on two legs tips over ahead onto its breast.</summary>
    /// <param name="tip">By how much its trunk tips, radians, nose up.</param>
    private static Act DyingOnBelly(float tip) =>
        Dying(
            new ActPhase("reel", 1.6f).To(Aside, 0.06f).To(Roll, -0.06f).To(NeckPitch, 0.3f).To(NeckSide, -0.3f).To(Lids, 0.5f).To(Jaw, 0.4f).To(Ears, 0.8f),
            new ActPhase("buckle", 1.2f, ActEase.In).To(ForeDown, 0.62f).To(HindDown, 0.45f).To(ForeFold, 0.6f).To(HindFold, 0.4f).To(Aside, 0f).To(NeckPitch, -0.1f),
            new ActPhase("drop", 1.4f, ActEase.In).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, -0.6f).To(Roll, 0f).To(Pitch, 0.4f * tip),
            new ActPhase("settle", 1.6f, ActEase.Out).To(Pitch, tip).To(NeckPitch, -0.9f).To(NeckSide, 0.5f).To(HeadPitch, 0.6f).To(HeadRoll, 0.25f).To(HeadSide, 0.2f).To(Lids, 0.8f).To(Jaw, 0.1f).To(TailSide, 0.4f).To(TailPitch, -0.3f + tip).To(ArmsOut, 0.3f),
            new ActPhase("still", 5f).Lasting(),
            new ActPhase("lift", 2.4f).To(Pitch, 0f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.4f).To(HindFold, 0.4f).To(NeckPitch, -0.4f).To(HeadPitch, 0f),
            new ActPhase("rise", 2.6f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(Lids, 0f).To(Jaw, 0f).To(Ears, 0f).To(TailSide, 0f).To(TailPitch, 0f).To(ArmsOut, 0f))
            .OnTheSpot();

    /// <summary>Over onto the flank, legs stretched out.</summary>
    private static ActPhase OntoFlank(string name, float duration, ActEase ease) =>
        new ActPhase(name, duration, ease).To(OnFlank, 1f).To(ForeDown, LyingSide.Flank.Down).To(HindDown, LyingSide.Flank.Down).To(ForeFold, 0f).To(HindFold, 0f).To(ForeFeetPitch, LyingSide.ToesDown).To(HindFeetPitch, LyingSide.ToesDown);

    /// <summary>Asleep on the belly, and awake again.</summary>
    /// <param name="nod">Where head, back and tail go.</param>
    private static ActPhase[] SleepBy(ActPhase nod) => new[]
    {
        nod.To(Lids, 1f).To(Ears, 0.35f),
        new ActPhase("sleep", 14f).Lasting().With(new ActWave(Up, 0.006f, 2.5f)),
        new ActPhase("wake", 2.4f).To(Lids, 0f).To(BackSide, 0f).To(Yaw, 0f).To(NeckPitch, 0.1f).To(HeadPitch, 0f).To(NeckSide, 0f).To(HeadSide, 0f).To(Ears, -0.3f).To(TailSide, 0f),
    };

    private static Act Dying(params ActPhase[] phases) => new Act("Die", ActKind.Posture, phases).FallingFromAir();

    private static Act Lying(string name, ActPhase[] phases) => new Act(name, ActKind.Posture, phases).Needing(ActNeeds.Legs).OnTheSpot();

    /// <summary>Down on the belly, what is done there, and up again: legs fold as the body comes down on them.</summary>
    private static ActPhase[] GettingDown(params ActPhase[] there)
    {
        var phases = new List<ActPhase>
        {
            new ActPhase("look", 1.4f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(ForeDown, 0.12f).To(HindDown, 0.12f),
            new ActPhase("crouch", 2.4f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.35f).To(HindFold, 0.35f).To(NeckPitch, -0.1f).To(HeadPitch, 0f),
            new ActPhase("sink", 2.8f).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, 0.1f),
        };
        phases.AddRange(there);
        phases.Add(new ActPhase("lift", 2.6f).To(ForeDown, 0.5f).To(HindDown, 0.5f).To(ForeFold, 0.35f).To(HindFold, 0.35f).To(NeckPitch, -0.15f).To(Lids, 0f));
        phases.Add(new ActPhase("stand", 2.6f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(TailSide, 0f));
        return phases.ToArray();
    }

    /// <summary>The same of an upright body: it squats, puts its hands down and lies down on its chest, its legs stretched out behind; and up again the same way.</summary>
    private static ActPhase[] GettingDownUpright(params ActPhase[] there)
    {
        var phases = new List<ActPhase>
        {
            new ActPhase("look", 1.2f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(HindDown, 0.12f),
            new ActPhase("squat", 2.2f).To(HindDown, Squat.HindDown).To(HindFold, 0.6f).To(ArmsAhead, 0.5f).To(NeckPitch, -0.1f).To(HeadPitch, 0f),
            new ActPhase("hands", 2.2f).To(HindDown, 0.62f).To(HindFold, 0.3f).To(ForeFold, 0.45f).To(ArmsAhead, 1.1f).To(NeckPitch, 0.3f),
            new ActPhase("sink", 2.6f).To(HindDown, 1f).To(HindFold, 0f).To(ForeFold, 1f).To(ArmsAhead, 1.3f).To(ArmsBend, 0.4f).To(NeckPitch, 0.6f).To(TailPitch, -0.8f),
        };
        phases.AddRange(there);
        phases.Add(new ActPhase("push", 2.4f).To(HindDown, 0.62f).To(HindFold, 0.3f).To(ForeFold, 0.45f).To(ArmsBend, 0f).To(ArmsAhead, 0.9f).To(NeckPitch, 0.3f).To(Lids, 0f).To(TailPitch, 0f));
        phases.Add(new ActPhase("gather", 2.2f).To(HindDown, 0.6f).To(HindFold, 0.6f).To(ForeFold, 0f).To(ArmsAhead, 0.3f).To(NeckPitch, -0.1f).To(TailSide, 0f));
        phases.Add(new ActPhase("stand", 2.2f).To(HindDown, 0f).To(HindFold, 0f).To(ArmsAhead, 0f).To(NeckPitch, 0f).To(Ears, 0f));
        return phases.ToArray();
    }

    /// <summary>The same onto its side: it squats and tips over, its legs bent beside it as they like; and up again the same way.</summary>
    private static ActPhase[] GettingDownSideways(params ActPhase[] there)
    {
        var phases = new List<ActPhase>
        {
            new ActPhase("look", 1.2f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(HindDown, 0.12f),
            new ActPhase("squat", 2.2f).To(HindDown, 0.65f).To(HindFold, 0.6f).To(ArmsAhead, 0.3f).To(NeckPitch, -0.1f).To(HeadPitch, 0f),
            new ActPhase("tip", 2.4f).To(HindDown, 0.5f).To(HindFold, 0.2f).To(ForeFold, 0.55f).To(OnFlank, 0.5f).To(ArmsAhead, 0.1f).To(ArmsOut, -0.45f).To(ArmOut, 0.25f).To(NeckSide, -0.5f),
            new ActPhase("side", 2.4f).To(HindDown, 0.4f).To(HindFold, 0f).To(ForeFold, 1f).To(OnFlank, 1f).To(NeckSide, -0.3f),
        };
        phases.AddRange(there);
        phases.AddRange(GettingUpSideways());
        return phases.ToArray();
    }

    private static ActPhase[] GettingUpSideways() => new[]
    {
        new ActPhase("tip back", 2.8f).To(HindDown, 0.5f).To(HindFold, 0.2f).To(ForeFold, 0.55f).To(OnFlank, 0.5f).To(NeckPitch, 0.1f).To(NeckSide, -0.5f).To(HeadSide, 0f).To(TailSide, 0f).To(Lids, 0f).To(Jaw, 0f),
        new ActPhase("gather", 2.4f).To(OnFlank, 0f).To(HindDown, 0.65f).To(HindFold, 0.6f).To(ForeFold, 0f).To(ArmsAhead, 0.3f).To(ArmsOut, 0f).To(ArmOut, 0f).To(NeckPitch, -0.1f).To(NeckSide, 0f),
        new ActPhase("stand", 2.2f).To(HindDown, 0f).To(HindFold, 0f).To(ArmsAhead, 0f).To(NeckPitch, 0f).To(Ears, 0f),
    };

    /// <summary>The same on paws: hips last, and up fore first.</summary>
    private static ActPhase[] GettingDownOnPaws(params ActPhase[] there)
    {
        var phases = new List<ActPhase>
        {
            new ActPhase("look", 1.4f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(ForeDown, 0.12f).To(HindDown, 0.12f),
            new ActPhase("elbows", 2.2f).To(ForeDown, 0.6f).To(HindDown, 0.3f).To(ForeFold, 0.6f).To(NeckPitch, 0f).To(HeadPitch, 0f),
            new ActPhase("sink", 2.6f).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, 0.1f),
        };
        phases.AddRange(there);
        phases.Add(new ActPhase("prop", 2.4f).To(ForeDown, 0.3f).To(HindDown, 0.85f).To(ForeFold, 0.3f).To(NeckPitch, 0.2f).To(Lids, 0f));
        phases.Add(new ActPhase("rump", 1.8f).To(ForeDown, 0.1f).To(HindDown, 0.3f).To(ForeFold, 0f).To(HindFold, 0.25f).To(NeckPitch, -0.1f));
        phases.Add(new ActPhase("stand", 1.6f).To(ForeDown, 0f).To(HindDown, 0f).To(HindFold, 0f).To(NeckPitch, 0f).To(TailSide, 0f).To(Ears, 0f));
        return phases.ToArray();
    }

    /// <summary>The same on hooves: down on the wrists first, and up hind first.</summary>
    private static ActPhase[] GettingDownOnHooves(params ActPhase[] there)
    {
        var phases = new List<ActPhase>
        {
            new ActPhase("look", 1.4f).To(NeckPitch, -0.35f).To(HeadPitch, -0.15f).To(ForeDown, 0.1f).To(HindDown, 0.08f),
            new ActPhase("kneel", 2.6f).To(ForeDown, 0.65f).To(HindDown, 0.2f).To(ForeFold, 0.7f).To(NeckPitch, -0.1f).To(HeadPitch, 0f),
            new ActPhase("sink", 3f).To(ForeDown, 0.97f).To(HindDown, 0.97f).To(ForeFold, 1f).To(HindFold, 1f).To(NeckPitch, 0.1f),
        };
        phases.AddRange(there);
        phases.Add(new ActPhase("rump", 2.8f).To(HindDown, 0.2f).To(HindFold, 0f).To(ForeDown, 0.65f).To(ForeFold, 0.7f).To(NeckPitch, -0.3f).To(Lids, 0f));
        phases.Add(new ActPhase("stand", 2.4f).To(ForeDown, 0f).To(HindDown, 0f).To(ForeFold, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(TailSide, 0f));
        return phases.ToArray();
    }
}
