using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Motion;

namespace CreatureGen.Genetics.Criteria;

/// <summary>A creature before its judges. What is not asked for is not built. For one thread at a time.</summary>
public sealed class Candidate
{
    private Creature? creature;
    private BodyMeasures? measures;
    private MotionProfile? profile;

    /// <summary>A creature that is still to be built.</summary>
    /// <param name="blueprint">Its blueprint, valid.</param>
    /// <param name="company">The blueprints of those that it lives with, itself left out.</param>
    public Candidate(CreatureBlueprint blueprint, IReadOnlyList<CreatureBlueprint> company)
    {
        Blueprint = blueprint ?? throw new ArgumentNullException(nameof(blueprint));
        Company = company ?? throw new ArgumentNullException(nameof(company));
    }

    /// <summary>A creature that is alone.</summary>
    public Candidate(Creature creature)
        : this((creature ?? throw new ArgumentNullException(nameof(creature))).Blueprint, Array.Empty<CreatureBlueprint>()) => this.creature = creature;

    /// <summary>Its blueprint.</summary>
    public CreatureBlueprint Blueprint { get; }

    /// <summary>The blueprints of those that it lives with.</summary>
    public IReadOnlyList<CreatureBlueprint> Company { get; }

    /// <summary>The creature itself, built when it is first asked for.</summary>
    public Creature Creature => creature ??= CreatureAssembler.Assemble(Blueprint);

    /// <summary>Its lengths.</summary>
    public BodyMeasures Measures => measures ??= BodyMeasures.Of(Creature);

    /// <summary>How it moves.</summary>
    public MotionProfile Profile => profile ??= new MotionProfile(Creature);
}
