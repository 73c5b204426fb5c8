namespace Unity.Entities;

public class InitializationSystemGroup : ComponentSystemGroup { }

public class SimulationSystemGroup : ComponentSystemGroup { }

[UpdateInGroup(typeof(SimulationSystemGroup), OrderFirst = true)]
public class FixedStepSimulationSystemGroup : ComponentSystemGroup
{
    bool m_isRun;

    /// <summary>As Unity's where no system tells the world's time: the first step alone.</summary>
    protected override void OnUpdate()
    {
        if (!m_isRun)
            base.OnUpdate();
        m_isRun = true;
    }
}

public class PresentationSystemGroup : ComponentSystemGroup { }
