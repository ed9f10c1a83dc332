using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>Acts that others are to see or hear.</summary>
internal static class Displays
{
    public static readonly Act[] All =
    {
        new Act("Call", ActKind.Display,
            new ActPhase("breath", 1.8f).To(NeckPitch, 0.9f).To(HeadPitch, -0.7f).Then(ActMark.SoundBegin),
            new ActPhase("hiss", 4f, ActEase.Out).To(Jaw, 0.9f).To(NeckPitch, 1.0f).With(new ActWave(HeadSide, 0.1f, 2f)),
            new ActPhase("close", 1f).To(Jaw, 0f).Then(ActMark.SoundEnd),
            new ActPhase("recover", 2.4f).To(NeckPitch, 0f).To(HeadPitch, 0f))
            .Needing(ActNeeds.Jaw).For(BodyBuild.Legless),
        RaisedFronts.Call,
        new Act("Call", ActKind.Display,
            new ActPhase("breath", 2.0f).To(Ahead, -0.14f).To(NeckPitch, -0.3f).To(HeadPitch, -0.2f).To(BackPitch, 0.12f).To(ForeDown, 0.08f).To(HindDown, 0.1f).To(TailPitch, -0.1f).AtLeast(0.2f).Then(ActMark.SoundBegin),
            new ActPhase("burst", 0.8f, ActEase.Over).To(Ahead, 0.12f).To(ForeDown, -0.04f).To(HindDown, 0.02f).To(NeckPitch, 0.35f).To(HeadPitch, 0.25f).To(Jaw, 1f).To(Ears, 0.6f).To(Lids, 0.3f).To(TailPitch, 0.4f).To(Wings, 0.4f).To(ArmsOut, 0.4f),
            new ActPhase("sustain", 4.5f).To(Jaw, 0.85f).To(Ahead, 0.04f).With(new ActWave(NeckSide, 0.15f, 1f)).With(new ActWave(HeadSide, 0.2f, 1f, 0.1f)).With(new ActWave(Jaw, 0.05f, 12f)).With(new ActWave(HeadPitch, 0.02f, 12f)),
            new ActPhase("close", 0.9f).To(Jaw, 0f).Then(ActMark.SoundEnd),
            new ActPhase("recover", 1.8f).To(Ahead, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(BackPitch, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(Ears, 0f).To(Lids, 0f).To(TailPitch, 0f).To(Wings, 0f).To(ArmsOut, 0f))
            .Needing(ActNeeds.Jaw),
        new Act("Threaten", ActKind.Display,
            new ActPhase("rise", 2.4f).To(NeckPitch, 1.25f).To(HeadPitch, -1.0f),
            new ActPhase("show", 6f).To(Jaw, 0.5f).With(new ActWave(NeckSide, 0.3f, 2f)).With(new ActWave(HeadSide, -0.2f, 2f)).With(new ActWave(NeckPitch, 0.15f, 4f, 0.25f)).With(new ActWave(Jaw, 0.2f, 4f, 0.5f)).With(new ActWave(TailSide, 0.4f, 2f, 0.3f)),
            new ActPhase("sink", 3f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Jaw, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Legless),
        new Act("Threaten", ActKind.Display,
            new ActPhase("turn", 2f).To(Wings, 1f).To(Yaw, 0.5f).To(BackSide, 0.35f).To(Jaw, 0.4f),
            new ActPhase("show", 6f).To(Jaw, 0.8f).With(new ActWave(Wings, 0.25f, 6f)).With(new ActWave(Roll, 0.15f, 2f)),
            new ActPhase("back", 2.4f).To(Wings, 0f).To(Yaw, 0f).To(BackSide, 0f).To(Jaw, 0f))
            .For(BodyBuild.Swimming | BodyBuild.Airborne),
        RaisedFronts.Threaten,
        new Act("Threaten", ActKind.Display,
            new ActPhase("gather", 1.4f).To(HindDown, 0.12f).To(Ahead, -0.05f).To(Ears, 0.9f),
            new ActPhase("rear", 1.8f, ActEase.Smooth).To(HindDown, 0.2f).To(Pitch, 0.4f).To(ForeFeetUp, 0.3f).To(ForeFeetAhead, 0.3f).To(ForeFeetOut, 0.15f).To(NeckPitch, 0.2f).To(Jaw, 0.8f).To(TailPitch, 0.5f).To(Wings, 0.8f).To(ArmsOut, 0.6f).To(ArmsAhead, 0.6f).To(ArmsBend, 0.5f),
            new ActPhase("show", 5f).With(new ActWave(ForeFootUp, 0.12f, 3f)).With(new ActWave(Roll, 0.06f, 2f)).With(new ActWave(NeckSide, 0.25f, 2f)).With(new ActWave(HeadSide, 0.15f, 2f, 0.1f)).With(new ActWave(TailSide, 0.5f, 2f, 0.3f)),
            new ActPhase("drop", 1.8f).To(Pitch, 0f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f).To(HindDown, 0f).To(Jaw, 0f),
            new ActPhase("recover", 1.6f).To(Ahead, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(TailPitch, 0f).To(Wings, 0f).To(ArmsOut, 0f).To(ArmsAhead, 0f).To(ArmsBend, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.ManyLegged | BodyBuild.Sprawling).OnTheSpot(),
        new Act("Threaten", ActKind.Display,
            new ActPhase("gather", 1.4f).To(ForeDown, 0.15f).To(HindDown, 0.15f).To(Ahead, -0.1f).To(Ears, 0.9f),
            new ActPhase("rise", 1.6f).To(ForeDown, -0.1f).To(HindDown, 0.1f).To(Ahead, 0.05f).To(ForeFeetUp, 0.45f).To(ForeFeetAhead, 0.25f).To(ForeFeetOut, 0.2f).To(NeckPitch, 0.6f).To(HeadPitch, 0.2f).To(Jaw, 0.9f).To(TailPitch, 0.8f).To(TailCurl, 0.5f).To(Wings, 0.8f),
            new ActPhase("show", 5f).With(new ActWave(ForeFootUp, 0.12f, 3f)).With(new ActWave(NeckSide, 0.25f, 2f)).With(new ActWave(HeadSide, 0.2f, 2f, 0.1f)).With(new ActWave(TailSide, 0.5f, 2f, 0.3f)),
            new ActPhase("drop", 1.8f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(Jaw, 0f),
            new ActPhase("recover", 1.6f).To(Ahead, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(Wings, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.ManyLegged).OnTheSpot(),
        new Act("Threaten", ActKind.Display,
            new ActPhase("rise", 1.6f).To(HindDown, 0.1f).To(Pitch, 0.3f).To(NeckPitch, 0.1f).To(Ears, 0.9f).To(Wings, 0.9f).To(ArmsOut, 0.9f).To(ArmsAhead, 0.5f).To(ArmsBend, 0.6f).To(TailPitch, -0.15f),
            new ActPhase("show", 6f).To(Jaw, 0.9f).To(Ahead, 0.08f).With(new ActWave(NeckSide, 0.25f, 2f)).With(new ActWave(HeadSide, 0.15f, 2f, 0.1f)).With(new ActWave(Roll, 0.06f, 2f, 0.1f)).With(new ActWave(Ahead, 0.05f, 2f)).With(new ActWave(ArmsAhead, 0.25f, 4f)).With(new ActWave(TailSide, 0.5f, 2f, 0.3f)).With(new ActWave(Wings, 0.1f, 6f)),
            new ActPhase("recover", 2.4f).To(HindDown, 0f).To(Pitch, 0f).To(NeckPitch, 0f).To(Ahead, 0f).To(Jaw, 0f).To(Ears, 0f).To(Wings, 0f).To(ArmsOut, 0f).To(ArmsAhead, 0f).To(ArmsBend, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Legs).For(BodyBuild.TwoLegged | BodyBuild.Upright).OnTheSpot(),
        new Act("Threaten", ActKind.Display,
            new ActPhase("lower", 1.8f).To(ForeDown, 0.22f).To(HindDown, 0.04f).To(NeckPitch, -0.45f).To(HeadPitch, 0.05f).To(Ears, 1f).To(TailPitch, 0.35f).To(Lids, 0.25f).To(Wings, 0.75f),
            new ActPhase("show", 3f).To(Jaw, 0.75f).To(Ahead, 0.1f).With(new ActWave(HeadSide, 0.16f, 1.5f)).With(new ActWave(TailSide, 0.3f, 2f)).With(new ActWave(Wings, 0.08f, 4f)),
            new ActPhase("paw", 0.8f).To(Aside, -0.06f).To(ForeFootUp, 0.14f).To(ForeFootAhead, 0.12f),
            new ActPhase("rake", 0.5f).To(ForeFootUp, 0.03f).To(ForeFootAhead, -0.12f),
            new ActPhase("paw again", 0.8f).To(ForeFootUp, 0.14f).To(ForeFootAhead, 0.12f),
            new ActPhase("set down", 0.7f).To(ForeFootUp, 0f).To(ForeFootAhead, 0f),
            new ActPhase("recover", 2.2f).To(Aside, 0f).To(Ahead, 0f).To(ForeDown, 0f).To(HindDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Jaw, 0f).To(Ears, 0f).To(TailPitch, 0f).To(Lids, 0f).To(Wings, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.Pawed | BodyBuild.Hoofed | BodyBuild.Columnar).OnTheSpot(),
        RaisedFronts.Submit,
        new Act("Submit", ActKind.Display,
            new ActPhase("cower", 1.4f).To(HindDown, 0.3f).To(ForeDown, 0.3f).To(Ahead, -0.06f).To(BackPitch, -0.2f).To(HeadPitch, -0.3f).To(Ears, 1f).To(ArmsBend, 0.8f).To(TailPitch, -0.3f),
            new ActPhase("bow", 2f).To(HindDown, 0.62f).To(ForeDown, 0.62f).To(Pitch, -0.5f).To(BackPitch, -0.6f).To(NeckPitch, -0.6f).To(HeadPitch, -0.35f).To(HeadSide, 0.25f).To(HeadRoll, 0.2f).To(Lids, 0.5f).To(TailPitch, -0.7f).To(TailCurl, -0.4f).To(Wings, -0.4f).To(ArmsAhead, 0.6f).To(ArmsOut, -0.2f).To(ArmsBend, 1.5f),
            new ActPhase("stay", 7f).To(HeadSide, 0.4f).With(new ActWave(Up, 0.006f, 12f)).With(new ActWave(HeadSide, 0.08f, 1f)).With(new ActWave(ArmsBend, 0.1f, 3f)),
            new ActPhase("look up", 1.4f).To(NeckPitch, -0.15f).To(HeadPitch, 0.2f).To(HeadSide, 0f).To(Lids, 0f),
            new ActPhase("rise", 2.4f).To(ForeDown, 0f).To(HindDown, 0f).To(Ahead, 0f).To(Pitch, 0f).To(BackPitch, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(Wings, 0f).To(ArmsAhead, 0f).To(ArmsOut, 0f).To(ArmsBend, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Upright).OnTheSpot(),
        new Act("Submit", ActKind.Display,
            new ActPhase("crouch", 1.8f).To(ForeDown, 0.56f).To(HindDown, 0.48f).To(Ahead, -0.08f).To(NeckPitch, -0.3f).To(HeadPitch, -0.2f).To(Ears, 1f).To(TailPitch, -0.3f).To(TailCurl, -0.3f).To(Wings, -0.4f),
            new ActPhase("turn away", 1.4f).To(NeckPitch, -0.5f).To(NeckSide, 0.4f).To(HeadSide, 0.25f).To(HeadRoll, 0.35f).To(TailSide, 0.5f).To(Lids, 0.4f),
            new ActPhase("stay", 6f).With(new ActWave(Up, 0.006f, 10f)).With(new ActWave(HeadSide, 0.08f, 1f)).With(new ActWave(TailSide, 0.12f, 2f)),
            new ActPhase("rise", 2.4f).To(ForeDown, 0f).To(HindDown, 0f).To(Ahead, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(HeadSide, 0f).To(HeadRoll, 0f).To(Ears, 0f).To(Lids, 0f).To(TailPitch, 0f).To(TailSide, 0f).To(TailCurl, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Sprawling | BodyBuild.ManyLegged).OnTheSpot(),
        new Act("Submit", ActKind.Display,
            new ActPhase("crouch", 2.2f).To(ForeDown, 0.45f).To(HindDown, 0.55f).To(Ahead, -0.10f).To(NeckPitch, -0.55f).To(HeadPitch, -0.05f).To(Ears, 1f).To(TailPitch, -0.6f).To(TailCurl, -0.4f).To(Wings, -0.4f).To(BackPitch, -0.15f),
            new ActPhase("turn away", 1.4f).To(NeckPitch, -0.8f).To(NeckSide, 0.35f).To(HeadSide, 0.3f).To(HeadRoll, 0.3f).To(Lids, 0.4f),
            new ActPhase("stay", 6f).With(new ActWave(Up, 0.006f, 10f)).With(new ActWave(HeadSide, 0.08f, 1f)),
            new ActPhase("look up", 1.4f).To(NeckPitch, -0.45f).To(NeckSide, 0.1f).To(HeadPitch, 0.2f).To(HeadSide, 0f).To(HeadRoll, 0f).To(Lids, 0f),
            new ActPhase("rise", 2.4f).To(ForeDown, 0f).To(HindDown, 0f).To(Ahead, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(Wings, 0f).To(BackPitch, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Standing).OnTheSpot(),
        new Act("Submit", ActKind.Display,
            new ActPhase("sink", 2.4f).To(Up, -0.35f).To(Ahead, -0.3f).To(Pitch, -0.3f).To(BackPitch, -0.15f).To(NeckPitch, -0.2f).To(HeadPitch, -0.2f).To(Ears, 1f).To(Lids, 0.4f).To(Wings, -0.4f),
            new ActPhase("show the belly", 2.2f).To(Roll, 0.85f).To(BackSide, 0.2f).To(NeckSide, 0.2f).To(HeadSide, 0.2f),
            new ActPhase("stay", 6f).With(new ActWave(Roll, 0.06f, 2f)).With(new ActWave(Up, 0.02f, 12f)),
            new ActPhase("look up", 1.6f).To(Roll, 0.2f).To(NeckPitch, -0.1f).To(NeckSide, 0.1f).To(HeadPitch, 0.15f).To(HeadSide, 0f).To(Lids, 0f),
            new ActPhase("level", 2.4f).To(Up, 0f).To(Ahead, 0f).To(Pitch, 0f).To(Roll, 0f).To(BackPitch, 0f).To(BackSide, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Swimming),
        new Act("Submit", ActKind.Display,
            new ActPhase("sink", 2.6f).To(ForeDown, 0.8f).To(NeckPitch, -0.15f).To(HeadPitch, -0.15f).To(NeckSide, 0.15f).To(Ears, 1f).To(Wings, -0.4f),
            new ActPhase("turn away", 1.8f).To(ForeDown, 1f).To(NeckSide, 0.7f).To(HeadSide, 0.3f).To(HeadRoll, 0.35f).To(Lids, 0.4f),
            new ActPhase("stay", 6f).With(new ActWave(HeadSide, 0.08f, 1f)).With(new ActWave(NeckSide, 0.03f, 8f)),
            new ActPhase("look up", 1.6f).To(ForeDown, 0.6f).To(NeckSide, 0.1f).To(HeadPitch, 0.15f).To(HeadSide, 0f).To(HeadRoll, 0f).To(Lids, 0f),
            new ActPhase("rise", 2.4f).To(ForeDown, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(Ears, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Legless),
        new Act("Submit", ActKind.Display,
            new ActPhase("shrink", 2.2f).To(Ahead, -0.10f).To(NeckPitch, -0.35f).To(HeadPitch, -0.1f).To(HeadRoll, 0.2f).To(Ears, 1f).To(Lids, 0.4f).To(TailPitch, -0.6f).To(TailCurl, -0.4f).To(Wings, -0.4f).To(BackPitch, -0.15f),
            new ActPhase("stay", 7f).With(new ActWave(Up, 0.006f, 12f)).With(new ActWave(HeadSide, 0.08f, 1f)),
            new ActPhase("straighten", 2.4f).To(Ahead, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(Ears, 0f).To(Lids, 0f).To(TailPitch, 0f).To(TailCurl, 0f).To(Wings, 0f).To(BackPitch, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Airborne).OnTheSpot(),
        RaisedFronts.Dance,
        Dances.OfFourLegs,
        Dances.OfLegs,
        Dances.OfFliers,
        Dances.OfSwimmers,
        Dances.OfCrawlers,
        RaisedFronts.Flinch,
        Flinches.OfManyLegs,
        Flinches.OfTwoLegs,
        Flinches.OfSwimmers,
        Flinches.OfFliers,
        Flinches.OfCrawlers,
        Flinches.OfPillars,
        Flinches.OfOthers,
    };
}
