using System.Collections.Generic;
using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>Dances: whatever was built can do one at once.</summary>
internal static class Dances
{
    private const float Beat = 1.5f;
    private const int Bars = 4;

    /// <summary>From side to side with a step on each beat, a dip in each bar and a turn of the head at its end.</summary>
    public static readonly Act OfLegs = new Act("Dance", ActKind.Display, Steps(0f)).Needing(ActNeeds.Legs).For(BodyBuild.Standing).OnTheSpot();

    /// <summary>The same with the hind foot across lifted along with each fore foot, as in a trot on the spot, and a turn in every other bar.</summary>
    public static readonly Act OfFourLegs = new Act("Dance", ActKind.Display, Steps(0.2f)).Needing(ActNeeds.FourLegs).For(BodyBuild.Standing).OnTheSpot();

    /// <summary>In water: from side to side and over from one to the other, with a dip and a rise at each end.</summary>
    public static readonly Act OfSwimmers = new Act("Dance", ActKind.Display,
        new ActPhase("rise", 2f).To(NeckPitch, 0.9f).To(HeadPitch, -0.6f).To(Wings, 0.5f),
        new ActPhase("sway", 14f)
            .With(new ActWave(Aside, 0.7f, 4f)).With(new ActWave(Up, 0.3f, 8f, 0.25f)).With(new ActWave(Yaw, 0.25f, 4f, 0.75f))
            .With(new ActWave(NeckSide, 0.5f, 4f)).With(new ActWave(HeadSide, 0.3f, 4f, 0.2f)).With(new ActWave(BackSide, 0.45f, 4f, 0.1f)).With(new ActWave(Roll, 0.6f, 4f, 0.15f))
            .With(new ActWave(Pitch, 0.2f, 8f)).With(new ActWave(Wings, 0.4f, 8f)).With(new ActWave(NeckPitch, 0.15f, 8f, 0.25f)),
        new ActPhase("sink", 2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Wings, 0f)).For(BodyBuild.Swimming);

    /// <summary>A crawler's, which lies on the ground: reared up it swings its head from side to side over its coils, higher at each end, and bows.</summary>
    public static readonly Act OfCrawlers = new Act("Dance", ActKind.Display,
        new ActPhase("rear", 2.2f).To(NeckPitch, 1f).To(HeadPitch, -0.8f),
        new ActPhase("sway", 14f)
            .With(new ActWave(NeckSide, 0.55f, 4f)).With(new ActWave(HeadSide, -0.3f, 4f, 0.2f)).With(new ActWave(HeadRoll, 0.25f, 4f, 0.1f)).With(new ActWave(NeckPitch, 0.16f, 8f, 0.25f)).With(new ActWave(TailSide, 0.3f, 4f, 0.4f)),
        new ActPhase("bow", 2f).To(NeckPitch, 0.2f).To(HeadPitch, -0.4f),
        new ActPhase("sink", 2f).To(NeckPitch, 0f).To(HeadPitch, 0f)).Needing(ActNeeds.Head).For(BodyBuild.Legless);

    /// <summary>On the wing: from bank to bank, swinging aside and up into each and stooping between them, with neck and tail across.</summary>
    public static readonly Act OfFliers = new Act("Dance", ActKind.Display,
        new ActPhase("rise", 4f).To(Up, 0.6f).To(Pitch, 0.25f).To(NeckPitch, 0.3f),
        new ActPhase("sway", 28f)
            .With(new ActWave(Aside, 1.1f, 4f)).With(new ActWave(Roll, 0.6f, 4f)).With(new ActWave(Yaw, 0.3f, 4f, 0.75f)).With(new ActWave(Up, 0.45f, 8f, 0.25f)).With(new ActWave(Pitch, 0.16f, 8f))
            .With(new ActWave(BackSide, 0.35f, 4f, 0.2f)).With(new ActWave(BackPitch, 0.2f, 8f, 0.1f)).With(new ActWave(NeckSide, 0.4f, 4f, 0.15f)).With(new ActWave(HeadRoll, 0.3f, 4f)).With(new ActWave(NeckPitch, 0.15f, 8f, 0.25f)).With(new ActWave(TailSide, 0.8f, 4f, 0.35f)).With(new ActWave(TailPitch, 0.25f, 8f, 0.4f)),
        new ActPhase("sink", 5f).To(Up, 0f).To(Pitch, 0f).To(NeckPitch, 0f)).For(BodyBuild.Airborne);

    /// <param name="across">How far the hind foot across is lifted with a fore foot.</param>
    private static ActPhase[] Steps(float across)
    {
        var steps = new List<ActPhase>();
        for (int bar = 0; bar < Bars; bar++)
        {
            steps.Add(Side("left", 1f, bar, across));
            steps.Add(Down("down", 1f));
            steps.Add(Side("right", -1f, bar, across));
            steps.Add(Down("down", -1f));
        }

        steps.Add(new ActPhase("bow", 2f).To(Aside, 0f).To(Roll, 0f).To(ForeDown, 0.35f).To(HindDown, 0f).To(NeckPitch, -0.3f).To(HeadSide, 0f).To(NeckSide, 0f).To(TailSide, 0f).To(TailPitch, 0.5f).To(Wings, 0.8f).To(ArmsOut, 0.5f).To(ArmsAhead, -0.2f).To(ArmsBend, 0f).To(BackSide, 0f).To(BackPitch, 0f));
        steps.Add(new ActPhase("rise", 2f).To(ForeDown, 0f).To(NeckPitch, 0f).To(TailPitch, 0f).To(Wings, 0f).To(ArmsOut, 0f).To(ArmsAhead, 0f).To(Ears, 0f));
        return steps.ToArray();
    }

    /// <summary>Weight onto a side, the feet of the other lifted: the fore foot of the act's own side, or both less that one.</summary>
    private static ActPhase Side(string name, float side, int bar, float across)
    {
        bool own = side < 0f;
        float hop = 0.26f;
        float turn = across == 0f || bar % 2 == 0 ? 0f : 0.15f * side;
        return new ActPhase(name, Beat * 0.55f)
            .To(Aside, 0.10f * side).To(Roll, -0.08f * side).To(BackSide, 0.16f * side).To(BackPitch, 0.08f).To(ForeDown, 0f).To(HindDown, 0.04f)
            .To(ForeFeetUp, own ? 0f : hop).To(ForeFootUp, own ? hop : -hop).To(HindFeetUp, own ? across : 0f).To(HindFootUp, own ? -across : across)
            .To(Yaw, turn).To(Wings, 0.6f)
            .To(NeckSide, 0.4f * side).To(NeckPitch, 0.35f).To(HeadSide, bar % 2 == 0 ? 0.2f * side : -0.2f * side).To(TailSide, -0.9f * side).To(TailPitch, 0.4f)
            .To(ArmsOut, 0.9f).To(ArmsAhead, 0.5f * side).To(ArmsBend, 0.7f).To(Ears, -0.4f);
    }

    private static ActPhase Down(string name, float side) =>
        new ActPhase(name, Beat * 0.45f).To(ForeFeetUp, 0f).To(ForeFootUp, 0f).To(HindFeetUp, 0f).To(HindFootUp, 0f).To(Yaw, 0f).To(Wings, 0.15f).To(BackPitch, -0.05f).To(ForeDown, 0.2f).To(HindDown, 0.16f).To(NeckPitch, -0.3f).To(HeadSide, 0f).To(Roll, 0.02f * side).To(ArmsOut, 0.2f);
}
