namespace CreatureGen.Motion;

/// <content>Its second head, where it has one.</content>
public sealed partial class CreatureAnimator
{
    /// <summary>Lets the second head go after the first and look for itself.</summary>
    /// <param name="awake">Whether the body moves by itself; else what moves it has put this head, too.</param>
    /// <param name="looks">Whether it looks where it is to, or about.</param>
    /// <param name="near">Whether it is seen from near.</param>
    /// <param name="lids">How far an act shuts the lids.</param>
    /// <param name="dt">Seconds.</param>
    private void MoveSecondHead(bool awake, bool looks, bool near, float lids, float dt)
    {
        if (secondHead == null)
        {
            return;
        }

        if (awake)
        {
            secondHead.Follow(dt, LocalPose, ModelPose);
        }
        else
        {
            secondHead.Rest(LocalPose);
        }

        if (near)
        {
            secondHead.Gaze.Lids = lids;
            secondHead.Gaze.IsLimp = State == BodyState.Limp;
            secondHead.Gaze.Update(looks ? lookAt : null, gaze, root, Mode?.Speed ?? 0f, looks ? settings.Idle : 0f, dt, LocalPose, ModelPose);
        }

        if (awake)
        {
            secondHead.KeepApart(LocalPose, ModelPose);
        }
    }
}
