using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Smooth"/>
internal sealed class SmoothnessCriterion : ICriterion
{
    private const float Hertz = 60f;

    /// <summary>What one can just see: slip and overlap in leg lengths, angles beyond limits in radians.</summary>
    private const double VisibleSlip = 0.01;
    private const double VisibleOverlap = 0.03;
    private const double VisibleAngle = 0.02;

    /// <inheritdoc/>
    public string Name => "smooth";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Motion;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        double faults = 0;
        foreach (Movement movement in Movement.OfGoing(candidate.Profile))
        {
            if (movement.IsCyclic)
            {
                MotionReport report = new MotionTrial(movement, GroundRelief.Flat, Hertz).Run(candidate.Profile);
                faults = Math.Max(faults, ((report.Slip ?? 0) / VisibleSlip) + ((report.LegOverlap ?? 0) / VisibleOverlap) + (report.LimitExcess / VisibleAngle));
            }
        }

        return 1 / (1 + faults);
    }
}
