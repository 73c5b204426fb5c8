namespace Unity.Entities;

public interface IQueryTypeParameter { }

public interface IComponentData : IQueryTypeParameter { }

public interface ICleanupComponentData : IComponentData { }

public interface IEnableableComponent { }
