using System;
using static CreatureGen.Motion.ActChannel;

namespace CreatureGen.Motion.Acts.Library;

/// <summary>Acts by which creatures look after themselves.</summary>
internal static class Upkeep
{
    public static readonly Act[] All =
    {
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("pick", 3f).To(ForeDown, 0.5f).To(ArmsAhead, 0.9f).To(NeckPitch, -0.3f),
            new ActPhase("lift", 2.4f).To(ForeDown, 0f).To(ArmsAhead, 0.75f).To(ArmsBend, 1.9f).To(NeckPitch, -0.25f).To(HeadPitch, -0.1f).To(Jaw, 0.5f),
            new ActPhase("bite", 0.7f).To(Jaw, 0f).Then(ActMark.Contact),
            new ActPhase("chew", 6f).To(HeadPitch, 0.1f).To(NeckPitch, -0.1f).With(new ActWave(Jaw, 0.2f, 5f, 0.25f)).With(new ActWave(HeadPitch, 0.04f, 5f)),
            new ActPhase("down", 2.4f).To(ArmsAhead, 0f).To(ArmsBend, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f))
            .Needing(ActNeeds.Jaw | ActNeeds.Arms).For(BodyBuild.Upright),
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("stoop", 2.4f).To(ForeDown, 0.75f).To(Reach, 0.85f).To(Jaw, 0.8f).To(TailSide, 0.3f),
            new ActPhase("bite", 0.6f).To(Reach, 1f).To(Jaw, 0.2f).Then(ActMark.Contact),
            new ActPhase("tear", 1.4f).To(Reach, 0.8f).With(new ActWave(NeckSide, 0.3f, 1.5f)).With(new ActWave(HeadRoll, 0.35f, 1.5f, 0.1f)),
            new ActPhase("raise", 2.2f).To(Reach, 0f).To(ForeDown, 0f).To(NeckPitch, 0.9f).To(HeadPitch, 0.35f).To(Jaw, 0.5f),
            new ActPhase("gulp", 7f).To(NeckPitch, 0.75f).To(Jaw, 0.1f).With(new ActWave(Jaw, 0.3f, 4f, 0.25f)).With(new ActWave(HeadPitch, 0.2f, 4f)).With(new ActWave(NeckPitch, 0.16f, 4f, 0.15f)).With(new ActWave(NeckSide, 0.2f, 2f)).With(new ActWave(TailSide, 0.3f, 2f, 0.3f)),
            new ActPhase("down", 3f).To(Jaw, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(TailSide, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth, 0.62f).For(BodyBuild.Legless),
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("rise", 2f).To(NeckPitch, 0.5f).To(HeadPitch, -0.4f),
            new ActPhase("take", 1f).To(Reach, 1f).To(Jaw, 0.8f),
            new ActPhase("bite", 0.5f).To(Jaw, 0.3f).Then(ActMark.Contact),
            new ActPhase("swallow", 10f).To(Reach, 0.6f).With(new ActWave(Jaw, 0.25f, 5f, 0.25f)).With(new ActWave(HeadSide, 0.15f, 2.5f)).With(new ActWave(NeckPitch, 0.06f, 5f)),
            new ActPhase("down", 3f).To(Reach, 0f).To(Jaw, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth, 0.2f).For(BodyBuild.Legless),
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("stoop", 3f).To(Pitch, -0.4f).To(BackPitch, -0.12f).To(Jaw, 0.7f).To(Reach, 0.9f).To(Wings, 0.4f),
            new ActPhase("snap", 0.5f).To(Jaw, 0f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("tear", 1.6f).To(Reach, 0.8f).With(new ActWave(HeadSide, 0.25f, 2f)).With(new ActWave(BackSide, 0.25f, 2f, 0.15f)),
            new ActPhase("chew", 5f).To(Pitch, -0.1f).To(BackPitch, 0f).To(Reach, 0.3f).To(Wings, 0.1f).With(new ActWave(Jaw, 0.4f, 4f, 0.25f)).With(new ActWave(HeadPitch, 0.06f, 4f)),
            new ActPhase("level", 2.4f).To(Pitch, 0f).To(Reach, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth).For(BodyBuild.Swimming),
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("near", 3f).To(Jaw, 0.6f).To(Reach, 0.9f),
            new ActPhase("snap", 0.5f).To(Jaw, 0f).To(Reach, 1f).Then(ActMark.Contact),
            new ActPhase("chew", 5f).To(Reach, 0.5f).With(new ActWave(Jaw, 0.25f, 4f, 0.25f)),
            new ActPhase("back", 3f).To(Reach, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth).For(BodyBuild.Airborne),
        RaisedFronts.Eat,
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("down", 3.2f).To(Reach, 0.92f).To(Jaw, 0.45f).To(Ears, -0.2f).To(TailPitch, 0.12f),
            new ActPhase("bite", 0.8f).To(Reach, 1f).To(Jaw, 0f).Then(ActMark.Contact),
            new ActPhase("tear", 1.2f).To(Reach, 0.75f).With(new ActWave(NeckSide, 0.25f, 1f)).With(new ActWave(HeadRoll, 0.25f, 1f, 0.2f)),
            new ActPhase("raise", 2f).To(Reach, 0f).To(NeckPitch, 0.4f).To(HeadPitch, -0.25f).To(ForeFeetUp, 0.26f).To(ForeFeetAhead, 0.12f).To(ForeFeetOut, -0.22f).To(ForeDown, -0.2f).To(Ahead, -0.06f),
            new ActPhase("chew", 7f).With(new ActWave(Jaw, 0.28f, 6f, 0.25f)).With(new ActWave(HeadPitch, 0.1f, 6f)).With(new ActWave(NeckSide, 0.15f, 2f)).With(new ActWave(HeadRoll, 0.12f, 3f)).With(new ActWave(ForeFootAhead, 0.05f, 6f)).With(new ActWave(Ears, 0.35f, 3f)).With(new ActWave(TailSide, 0.4f, 1.5f)),
            new ActPhase("put down", 1.4f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f),
            new ActPhase("level", 2.2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Ahead, 0f).To(ForeDown, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head | ActNeeds.FourLegs).With(ActTool.Mouth, 0.95f).For(BodyBuild.ManyLegged).OnTheSpot(),
        new Act("Eat", ActKind.Upkeep,
            new ActPhase("down", 3.2f).To(Reach, 0.92f).To(Jaw, 0.45f).To(Ears, -0.2f).To(TailPitch, 0.12f),
            new ActPhase("bite", 0.8f).To(Reach, 1f).To(Jaw, 0f).Then(ActMark.Contact),
            new ActPhase("tear", 0.7f).To(Reach, 0.8f).To(HeadSide, 0.2f).To(HeadRoll, 0.15f),
            new ActPhase("chew", 5f).To(Reach, 0.55f).To(HeadSide, 0f).To(HeadRoll, 0f).To(NeckSide, 0.15f).With(new ActWave(Jaw, 0.28f, 5f, 0.25f)).With(new ActWave(HeadRoll, 0.05f, 2.5f)).With(new ActWave(Ears, 0.35f, 3f)).With(new ActWave(TailSide, 0.4f, 1.5f)),
            new ActPhase("down again", 1.6f).To(Reach, 0.92f).To(Jaw, 0.45f).To(NeckSide, -0.1f),
            new ActPhase("bite again", 0.8f).To(Reach, 1f).To(Jaw, 0f),
            new ActPhase("tear again", 0.7f).To(Reach, 0.8f).To(HeadSide, -0.2f).To(HeadRoll, -0.15f),
            new ActPhase("chew again", 4f).To(Reach, 0.6f).To(HeadSide, 0f).To(HeadRoll, 0f).With(new ActWave(Jaw, 0.28f, 4f, 0.25f)).With(new ActWave(HeadRoll, 0.05f, 2f)).With(new ActWave(Ears, 0.35f, 2f)).With(new ActWave(TailSide, 0.4f, 1f)),
            new ActPhase("up", 2.8f).To(Reach, 0f).To(Ears, 0f).To(NeckSide, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.95f).For(BodyBuild.Standing),
        new Act("Drink", ActKind.Upkeep,
            new ActPhase("down", 3f).To(Reach, 1f).To(Jaw, 0.15f).Then(ActMark.Contact),
            new ActPhase("scoop", 0.9f).To(Jaw, 0.3f),
            new ActPhase("raise", 2.2f).To(Reach, 0f).To(NeckPitch, 0.7f).To(HeadPitch, 0.5f).To(Jaw, 0.05f),
            new ActPhase("swallow", 2.4f).With(new ActWave(Jaw, 0.08f, 3f, 0.25f)).With(new ActWave(NeckPitch, 0.04f, 3f)),
            new ActPhase("level", 2.2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Jaw, 0f))
            .Needing(ActNeeds.Jaw).With(ActTool.Mouth, 0.8f).For(BodyBuild.TwoLegged),
        new Act("Drink", ActKind.Upkeep,
            new ActPhase("down", 3.2f).To(Reach, 1f).To(Jaw, 0.08f).To(Ears, 0.2f).Then(ActMark.Contact),
            new ActPhase("lap", 6f).With(new ActWave(Jaw, 0.22f, 6f)).With(new ActWave(HeadPitch, 0.05f, 6f, 0.2f)).With(new ActWave(Ears, 0.3f, 2f)).With(new ActWave(TailSide, 0.4f, 1.5f)),
            new ActPhase("listen", 2f).To(Reach, 0.4f).To(Jaw, 0f).To(Ears, -0.6f).To(NeckSide, 0.3f).To(HeadSide, 0.25f).To(HeadPitch, 0.2f).To(TailPitch, 0.15f),
            new ActPhase("swallow", 1.8f).With(new ActWave(Jaw, 0.08f, 3f, 0.25f)).With(new ActWave(NeckPitch, 0.03f, 3f)).With(new ActWave(Ears, 0.3f, 1f)),
            new ActPhase("down again", 2f).To(Reach, 1f).To(Jaw, 0.08f).To(Ears, 0.2f).To(NeckSide, 0f).To(HeadSide, 0f).To(HeadPitch, 0f).To(TailPitch, 0f),
            new ActPhase("lap again", 5f).With(new ActWave(Jaw, 0.22f, 5f)).With(new ActWave(HeadPitch, 0.05f, 5f, 0.2f)).With(new ActWave(Ears, 0.3f, 1f)).With(new ActWave(TailSide, 0.4f, 1f)),
            new ActPhase("up", 2.8f).To(Reach, 0f).To(Jaw, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.75f).For(BodyBuild.Standing),
        new Act("Sniff", ActKind.Upkeep,
            new ActPhase("near", 3f).To(Pitch, -0.25f).To(NeckPitch, -0.2f).To(Reach, 1f).To(Ears, -0.7f).To(TailPitch, 0.3f).Then(ActMark.Contact),
            new ActPhase("weave", 8f).To(Reach, 0.6f).With(new ActWave(Aside, 0.5f, 2f)).With(new ActWave(Yaw, 0.25f, 2f, 0.3f)).With(new ActWave(Roll, 0.2f, 2f)).With(new ActWave(NeckSide, 0.35f, 2f, 0.15f)).With(new ActWave(HeadPitch, 0.1f, 8f)).With(new ActWave(Ears, 0.4f, 6f, 0.3f)).With(new ActWave(TailSide, 0.3f, 2f, 0.4f)),
            new ActPhase("back", 3f).To(Reach, 0f).To(Pitch, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.5f).For(BodyBuild.Airborne),
        new Act("Sniff", ActKind.Upkeep,
            new ActPhase("near", 3f).To(Pitch, -0.3f).To(BackPitch, -0.1f).To(NeckPitch, -0.15f).To(Reach, 1f).To(Wings, 0.3f).Then(ActMark.Contact),
            new ActPhase("weave", 8f).To(Reach, 0.6f).With(new ActWave(Aside, 0.35f, 2f)).With(new ActWave(Yaw, 0.22f, 2f, 0.3f)).With(new ActWave(Roll, 0.25f, 2f)).With(new ActWave(BackSide, 0.3f, 2f, 0.1f)).With(new ActWave(NeckSide, 0.35f, 2f, 0.2f)).With(new ActWave(HeadPitch, 0.06f, 8f)).With(new ActWave(Wings, 0.15f, 4f)),
            new ActPhase("scent", 2.4f).To(Reach, 0f).To(Pitch, 0.12f).To(BackPitch, 0.08f).To(NeckPitch, 0.2f).To(HeadPitch, 0.2f).With(new ActWave(HeadSide, 0.15f, 1f)),
            new ActPhase("back", 2.4f).To(Pitch, 0f).To(BackPitch, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(Wings, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.4f).For(BodyBuild.Swimming),
        RaisedFronts.Sniff,
        new Act("Sniff", ActKind.Upkeep,
            new ActPhase("rise", 1.6f).To(ForeDown, -0.09f).To(NeckPitch, 0.55f).To(HeadPitch, 0.2f).To(BackSide, 0.08f).To(NeckSide, 0.4f).To(TailPitch, 0.2f).To(TailSide, -0.3f),
            new ActPhase("towards", 2.2f).To(ForeDown, 0.08f).To(Ahead, 0.10f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(BackSide, 0f).To(NeckSide, 0f).To(Reach, 1f).To(Ears, -0.7f).To(TailSide, 0f).Then(ActMark.Contact),
            new ActPhase("sniff", 6f).To(Reach, 0.4f).With(new ActWave(BackSide, 0.08f, 2f)).With(new ActWave(NeckSide, 0.5f, 2f, 0.1f)).With(new ActWave(HeadSide, 0.25f, 2f, 0.15f)).With(new ActWave(HeadPitch, 0.10f, 8f)).With(new ActWave(Jaw, 0.05f, 8f)).With(new ActWave(Ears, 0.4f, 6f, 0.3f)).With(new ActWave(TailSide, 0.3f, 2f, 0.4f)),
            new ActPhase("back", 2.4f).To(Reach, 0f).To(Ahead, 0f).To(ForeDown, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.4f).For(BodyBuild.Sprawling | BodyBuild.ManyLegged),
        new Act("Sniff", ActKind.Upkeep,
            new ActPhase("down", 2.6f).To(Reach, 1f).To(Ears, -0.5f).To(TailPitch, 0.1f).Then(ActMark.Contact),
            new ActPhase("track", 6f).To(Reach, 0.88f).With(new ActWave(Reach, 0.04f, 6f)).With(new ActWave(NeckSide, 0.4f, 2f)).With(new ActWave(HeadSide, 0.25f, 2f, 0.1f)).With(new ActWave(HeadPitch, 0.05f, 10f)).With(new ActWave(Jaw, 0.05f, 10f)).With(new ActWave(Ears, 0.3f, 5f, 0.3f)).With(new ActWave(TailSide, 0.25f, 2f)),
            new ActPhase("to the wind", 2.4f).To(Reach, 0f).To(NeckPitch, 0.28f).To(HeadPitch, 0.3f).To(HeadSide, 0.15f).To(Ears, -0.7f),
            new ActPhase("scent", 2.4f).To(HeadSide, -0.15f).With(new ActWave(HeadPitch, 0.08f, 5f)).With(new ActWave(Jaw, 0.05f, 5f)),
            new ActPhase("back", 2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadSide, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.75f).For(BodyBuild.Pawed | BodyBuild.Hoofed | BodyBuild.Columnar | BodyBuild.TwoLegged),
        new Act("Sniff", ActKind.Upkeep,
            new ActPhase("towards", 2.2f).To(Reach, 1f).To(Ears, -0.7f).To(TailPitch, 0.1f).Then(ActMark.Contact),
            new ActPhase("sniff", 5f).To(Reach, 0.75f).With(new ActWave(Reach, 0.05f, 6f)).With(new ActWave(NeckSide, 0.4f, 1.5f)).With(new ActWave(HeadSide, 0.25f, 1.5f, 0.1f)).With(new ActWave(HeadPitch, 0.05f, 9f)).With(new ActWave(Jaw, 0.05f, 9f)).With(new ActWave(Ears, 0.3f, 5f, 0.3f)).With(new ActWave(TailSide, 0.2f, 2f)),
            new ActPhase("to the wind", 1.8f).To(Reach, 0f).To(NeckPitch, 0.28f).To(HeadPitch, 0.3f).To(HeadSide, 0.15f).To(Ears, -0.4f),
            new ActPhase("scent", 2.4f).To(HeadSide, -0.15f).With(new ActWave(HeadPitch, 0.08f, 5f)).With(new ActWave(Jaw, 0.05f, 5f)),
            new ActPhase("back", 2f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadSide, 0f).To(Ears, 0f).To(TailPitch, 0f))
            .Needing(ActNeeds.Head).With(ActTool.Mouth, 0.4f),
        RaisedFronts.Shake,
        new Act("Shake", ActKind.Upkeep,
            new ActPhase("crouch", 1.2f).To(ForeDown, 0.2f).To(HindDown, 0.2f).To(NeckPitch, -0.3f).To(TailPitch, 0.35f).To(Ears, 0.3f).To(Lids, 1f),
            new ActPhase("shake", 7f).To(ForeDown, 0f).To(HindDown, 0f)
                .With(new ActWave(Roll, 0.1f, 6f)).With(new ActWave(BackTwist, 0.1f, 6f, 0.14f)).With(new ActWave(HeadRoll, 0.5f, 6f, 0.8f)).With(new ActWave(NeckSide, 0.35f, 6f, 0.9f)).With(new ActWave(HeadSide, 0.2f, 6f, 0.9f))
                .With(new ActWave(TailSide, 1.1f, 6f, 0.35f)).With(new ActWave(TailPitch, 0.22f, 12f, 0.35f)).With(new ActWave(Ears, 0.9f, 6f, 0.1f)).With(new ActWave(ArmsOut, 0.16f, 6f, 0.1f)).With(new ActWave(Wings, 0.3f, 6f, 0.2f)),
            new ActPhase("stretch", 1.2f).To(NeckPitch, 0.3f).To(HeadPitch, 0.1f).To(Ears, -0.3f).To(Lids, 0f),
            new ActPhase("recover", 1.8f).To(ForeDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(TailPitch, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Sprawling | BodyBuild.ManyLegged).OnTheSpot(),
        new Act("Shake", ActKind.Upkeep,
            new ActPhase("brace", 1.2f).To(ForeDown, 0.08f).To(HindDown, 0.06f).To(NeckPitch, -0.45f).To(HeadPitch, -0.1f).To(TailPitch, 0.25f).To(Ears, 0.3f).To(Lids, 1f),
            new ActPhase("shake", 7f)
                .With(new ActWave(HeadRoll, 0.45f, 6f)).With(new ActWave(HeadSide, 0.2f, 6f, 0.1f)).With(new ActWave(NeckTwist, 0.55f, 6f)).With(new ActWave(NeckSide, 0.22f, 6f, 0.06f)).With(new ActWave(BackTwist, 0.22f, 6f, 0.14f)).With(new ActWave(Roll, 0.05f, 6f, 0.2f))
                .With(new ActWave(TailSide, 0.8f, 6f, 0.35f)).With(new ActWave(TailPitch, 0.22f, 12f, 0.35f)).With(new ActWave(Ears, 0.9f, 6f, 0.1f)).With(new ActWave(ArmsOut, 0.16f, 6f, 0.1f)).With(new ActWave(Wings, 0.15f, 6f, 0.2f)),
            new ActPhase("stretch", 1.2f).To(NeckPitch, 0.3f).To(HeadPitch, 0.1f).To(Ears, -0.3f).To(Lids, 0f),
            new ActPhase("recover", 1.8f).To(ForeDown, 0f).To(HindDown, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(TailPitch, 0f).To(Ears, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Standing).OnTheSpot(),
        new Act("Scratch", ActKind.Upkeep,
            new ActPhase("lower", 1.6f).To(HindDown, 0.4f).To(HindFold, 0.3f).To(BackSide, 0.15f).To(NeckSide, 0.2f),
            new ActPhase("settle", 1.8f).To(HindDown, 0.97f).To(HindFold, 1f).To(BackSide, 0.35f).To(NeckSide, 0.5f).To(TailPitch, 0.9f),
            new ActPhase("draw out", 1.4f).To(HindFootUp, 0.25f).To(HindFootAhead, 0.45f).To(HindFootOut, 0.25f).To(NeckSide, 0.8f),
            new ActPhase("raise", 1.8f).To(HindFootUp, 0.52f).To(HindFootAhead, 0.8f).To(HindFootPitch, -0.3f).To(NeckSide, 1.1f).To(NeckPitch, -0.3f).To(HeadRoll, 0.5f).To(HeadSide, 0.3f).To(Lids, 0.7f),
            new ActPhase("scratch", 7f).With(new ActWave(HindFootUp, 0.09f, 9f)).With(new ActWave(HindFootAhead, 0.08f, 9f, 0.25f)).With(new ActWave(HeadRoll, 0.05f, 9f)),
            new ActPhase("put down", 1.6f).To(HindFootUp, 0.25f).To(HindFootAhead, 0.45f).To(HindFootPitch, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(NeckPitch, 0f).To(NeckSide, 0.3f).To(Lids, 0f),
            new ActPhase("draw in", 1.6f).To(HindFootUp, 0f).To(HindFootAhead, 0f).To(HindFootOut, 0f),
            new ActPhase("rise", 1.6f).To(HindDown, 0.4f).To(HindFold, 0.3f).To(TailPitch, 0.3f).To(BackSide, 0.1f).To(NeckSide, 0f),
            new ActPhase("stand", 1.6f).To(HindDown, 0f).To(HindFold, 0f).To(TailPitch, 0f).To(BackSide, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.Pawed).OnTheSpot(),
        new Act("Scratch", ActKind.Upkeep,
            new ActPhase("squat", 2.2f).To(Aside, -0.1f).To(HindDown, 0.6f).To(BackSide, 0.35f).To(NeckSide, 0.4f),
            new ActPhase("raise", 1.8f).To(HindFootUp, 0.62f).To(HindFootAhead, 0.75f).To(HindFootOut, 0.16f).To(NeckSide, 0.9f).To(NeckPitch, -0.2f).To(HeadRoll, 0.5f).To(HeadSide, 0.3f).To(Lids, 0.7f),
            new ActPhase("scratch", 7f).With(new ActWave(HindFootUp, 0.07f, 9f)).With(new ActWave(HindFootAhead, 0.06f, 9f, 0.25f)).With(new ActWave(HeadRoll, 0.05f, 9f)),
            new ActPhase("lower", 1.8f).To(HindFootUp, 0f).To(HindFootAhead, 0f).To(HindFootOut, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(NeckPitch, 0f).To(Lids, 0f),
            new ActPhase("stand", 2f).To(Aside, 0f).To(HindDown, 0f).To(BackSide, 0f).To(NeckSide, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.Pawed).OnTheSpot(),
        new Act("Groom", ActKind.Upkeep,
            new ActPhase("raise", 2f).To(ArmsAhead, 1.5f).To(ArmsOut, -0.35f).To(ArmsBend, 1.5f).To(BackPitch, -0.15f).To(NeckPitch, -1f).To(HeadPitch, -0.6f).To(ForeDown, 0.08f),
            new ActPhase("rub", 8f).To(Lids, 0.8f).With(new ActWave(ArmsAhead, 0.18f, 7f)).With(new ActWave(ArmsBend, 0.25f, 7f, 0.2f)).With(new ActWave(NeckSide, 0.2f, 2f)).With(new ActWave(HeadSide, 0.25f, 2f)).With(new ActWave(HeadRoll, 0.25f, 2f, 0.15f)).With(new ActWave(HeadPitch, 0.12f, 7f)),
            new ActPhase("one cheek", 5f).To(ArmAhead, 0.35f).To(ArmOut, -0.15f).To(HeadRoll, 0.4f).To(HeadSide, 0.3f).With(new ActWave(ArmBend, 0.3f, 7f)).With(new ActWave(ArmAhead, 0.15f, 7f, 0.2f)),
            new ActPhase("lower", 2f).To(ArmsAhead, 0f).To(ArmsOut, 0f).To(ArmsBend, 0f).To(ArmAhead, 0f).To(ArmOut, 0f).To(BackPitch, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(Lids, 0f).To(ForeDown, 0f))
            .Needing(ActNeeds.Head | ActNeeds.Arms).For(BodyBuild.Pawed | BodyBuild.Hoofed | BodyBuild.Columnar | BodyBuild.TwoLegged),
        new Act("Groom", ActKind.Upkeep,
            new ActPhase("raise", 2f).To(ArmsAhead, 1f).To(ArmsOut, -0.2f).To(ArmsBend, 1.9f).To(NeckPitch, -0.4f).To(HeadPitch, -0.3f).To(ForeDown, 0.05f),
            new ActPhase("rub", 8f).To(Lids, 0.8f).With(new ActWave(ArmsAhead, 0.18f, 7f)).With(new ActWave(ArmsBend, 0.25f, 7f, 0.2f)).With(new ActWave(NeckSide, 0.2f, 2f)).With(new ActWave(HeadSide, 0.3f, 2f)).With(new ActWave(HeadRoll, 0.25f, 2f, 0.15f)).With(new ActWave(HeadPitch, 0.12f, 7f)),
            new ActPhase("behind an ear", 5f).To(ArmAhead, 0.35f).To(ArmOut, 0.35f).To(NeckSide, 0.3f).To(HeadRoll, 0.4f).To(HeadSide, 0.3f).With(new ActWave(ArmBend, 0.3f, 7f)).With(new ActWave(ArmAhead, 0.1f, 7f, 0.2f)),
            new ActPhase("lower", 2f).To(ArmsAhead, 0f).To(ArmsOut, 0f).To(ArmsBend, 0f).To(ArmAhead, 0f).To(ArmOut, 0f).To(NeckPitch, 0f).To(NeckSide, 0f).To(HeadPitch, 0f).To(HeadRoll, 0f).To(HeadSide, 0f).To(Lids, 0f).To(ForeDown, 0f))
            .Needing(ActNeeds.Head | ActNeeds.Arms).For(BodyBuild.Standing),
        RaisedFronts.Groom,
        new Act("Groom", ActKind.Upkeep,
            new ActPhase("raise", 1.6f).To(Ahead, -0.06f).To(NeckPitch, -0.25f).To(HeadPitch, -0.3f).To(ForeFeetUp, 0.26f).To(ForeFeetAhead, 0.12f).To(ForeFeetOut, -0.22f).To(Ears, 0.4f),
            new ActPhase("rub", 8f).With(new ActWave(ForeFootAhead, 0.08f, 7f)).With(new ActWave(ForeFeetUp, 0.05f, 3.5f)).With(new ActWave(NeckSide, 0.3f, 2f)).With(new ActWave(HeadSide, 0.3f, 2f, 0.1f)).With(new ActWave(HeadRoll, 0.25f, 2f, 0.2f)).With(new ActWave(HeadPitch, 0.1f, 4f)).With(new ActWave(Ears, 0.35f, 4f)),
            new ActPhase("lower", 1.4f).To(ForeFeetUp, 0f).To(ForeFeetAhead, 0f).To(ForeFeetOut, 0f).To(Ears, 0f),
            new ActPhase("recover", 1.2f).To(Ahead, 0f).To(NeckPitch, 0f).To(HeadPitch, 0f))
            .Needing(ActNeeds.FourLegs).For(BodyBuild.ManyLegged).OnTheSpot(),
        GroomingForeLeg(0.38f, 0.12f, 0.9f).For(BodyBuild.Pawed),
        GroomingForeLeg(0f, 0.22f, 0.9f).For(BodyBuild.Hoofed | BodyBuild.Columnar),
        GroomingForeLeg(0f, 0f, 0.3f).For(BodyBuild.Sprawling),
        new Act("Groom", ActKind.Upkeep,
            new ActPhase("turn", 2.4f).To(BackSide, 0.3f).To(Yaw, 0.05f).To(NeckSide, 1.3f).To(NeckPitch, -0.7f).To(HeadSide, 0.6f).To(HeadPitch, -0.6f).To(Lids, 0.4f),
            new ActPhase("nibble", 6f).With(new ActWave(Jaw, 0.14f, 10f, 0.25f)).With(new ActWave(NeckPitch, 0.12f, 2f)).With(new ActWave(NeckSide, 0.1f, 1f)).With(new ActWave(HeadSide, 0.08f, 4f)),
            new ActPhase("back", 2.4f).To(BackSide, 0f).To(Yaw, 0f).To(NeckSide, 0f).To(NeckPitch, 0f).To(HeadSide, 0f).To(HeadPitch, 0f).To(Lids, 0f))
            .Needing(ActNeeds.Head).For(BodyBuild.Standing),
    };

    /// <summary>A fore leg set ahead or raised, and the head bowed to it: licked, nibbled, rubbed with the cheek.</summary>
    /// <param name="up">How far the foot is held up.</param>
    /// <param name="ahead">How far it is ahead.</param>
    /// <param name="snoutDown">How far the snout points down at it, radians.</param>
    private static Act GroomingForeLeg(float up, float ahead, float snoutDown) => new Act("Groom", ActKind.Upkeep,
        new ActPhase("set ahead", 1.8f).To(Aside, -0.06f).To(ForeFootUp, Math.Max(up, 0.5f * ahead)).To(ForeFootAhead, 0.7f * ahead).To(ForeFootPitch, 0.8f * up).To(NeckPitch, -0.1f).To(NeckSide, 0.2f),
        new ActPhase("bow", 2.2f).To(ForeFootUp, up).To(ForeFootAhead, ahead).To(ForeFootPitch, 1.6f * up).To(Reach, 1f).To(Lids, 0.5f).To(Ears, 0.3f).To(TailPitch, 0.1f).Then(ActMark.Contact),
        new ActPhase("nibble", 8f).To(Reach, 0.94f).With(new ActWave(Reach, 0.05f, 5f)).With(new ActWave(Jaw, 0.16f, 10f, 0.25f)).With(new ActWave(HeadRoll, 0.16f, 2.5f)).With(new ActWave(HeadSide, 0.1f, 2.5f, 0.2f)).With(new ActWave(Ears, 0.3f, 2f)).With(new ActWave(TailSide, 0.3f, 1.5f)),
        new ActPhase("look up", 2.2f).To(Reach, 0f).To(ForeFootPitch, 0.8f * up).To(NeckPitch, 0.15f).To(NeckSide, 0f).To(Lids, 0f).To(Ears, -0.3f),
        new ActPhase("put down", 1.2f).To(ForeFootUp, up == 0f && ahead > 0f ? 0.5f * ahead : 0f).To(ForeFootAhead, up == 0f ? 0.4f * ahead : 0f).To(ForeFootPitch, 0f),
        new ActPhase("stand", 1.2f).To(ForeFootUp, 0f).To(ForeFootAhead, 0f).To(Aside, 0f).To(NeckPitch, 0f).To(Ears, 0f).To(TailPitch, 0f))
        .Needing(ActNeeds.Head | ActNeeds.FourLegs).With(ActTool.Mouth, snoutDown).OnItself().OnTheSpot();
}
