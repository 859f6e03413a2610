! Exact solutions for programs in Fortran, over seiche.h: create by name, evaluate at arrays of points.
!
!   type(seiche_solution) :: wave
!   wave = seiche_create('solitary', 'amplitude=0.3,depth=1,gravity=9.81')
!   if (.not. wave%ok()) error stop seiche_error()
!   call wave%evaluate(points, values, status)        ! points(coordinates, n), values(outputs, n); NaN outside the water
!   call wave%destroy()
module seiche
  use, intrinsic :: iso_c_binding
  implicit none
  private
  public :: seiche_solution, seiche_create, seiche_error

  type :: seiche_solution
    private
    type(c_ptr) :: handle = c_null_ptr
  contains
    procedure :: ok, inputs, outputs, evaluate, scalar, destroy
  end type

  interface
    function c_create(name, parameters) bind(c, name='seiche_create')
      import :: c_ptr, c_char
      character(kind=c_char), intent(in) :: name(*), parameters(*)
      type(c_ptr) :: c_create
    end function
    subroutine c_free(solution) bind(c, name='seiche_free')
      import :: c_ptr
      type(c_ptr), value :: solution
    end subroutine
    function c_inputs(solution) bind(c, name='seiche_inputs')
      import :: c_ptr, c_size_t
      type(c_ptr), value :: solution
      integer(c_size_t) :: c_inputs
    end function
    function c_outputs(solution) bind(c, name='seiche_outputs')
      import :: c_ptr, c_size_t
      type(c_ptr), value :: solution
      integer(c_size_t) :: c_outputs
    end function
    function c_evaluate(solution, count, points, values) bind(c, name='seiche_evaluate')
      import :: c_ptr, c_size_t, c_double, c_int
      type(c_ptr), value :: solution
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: points(*)
      real(c_double), intent(out) :: values(*)
      integer(c_int) :: c_evaluate
    end function
    function c_scalar(solution, name) bind(c, name='seiche_scalar')
      import :: c_ptr, c_char, c_double
      type(c_ptr), value :: solution
      character(kind=c_char), intent(in) :: name(*)
      real(c_double) :: c_scalar
    end function
    function c_error() bind(c, name='seiche_error')
      import :: c_ptr
      type(c_ptr) :: c_error
    end function
    function c_length(text) bind(c, name='strlen')
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
      integer(c_size_t) :: c_length
    end function
  end interface

contains

  function seiche_create(name, parameters) result(solution)
    character(*), intent(in) :: name, parameters
    type(seiche_solution) :: solution
    solution%handle = c_create(trim(name)//c_null_char, trim(parameters)//c_null_char)
  end function

  function seiche_error() result(text)
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: k
    call c_f_pointer(c_error(), letters, [c_length(c_error())])
    allocate(character(size(letters)) :: text)
    do k = 1, size(letters)
      text(k:k) = letters(k)
    end do
  end function

  logical function ok(self)
    class(seiche_solution), intent(in) :: self
    ok = c_associated(self%handle)
  end function

  integer function inputs(self)
    class(seiche_solution), intent(in) :: self
    inputs = int(c_inputs(self%handle))
  end function

  integer function outputs(self)
    class(seiche_solution), intent(in) :: self
    outputs = int(c_outputs(self%handle))
  end function

  ! status 1 where seiche_error() says why, also for arrays of another shape
  subroutine evaluate(self, points, values, status)
    class(seiche_solution), intent(in) :: self
    real(c_double), intent(in), contiguous :: points(:, :)
    real(c_double), intent(out), contiguous :: values(:, :)
    integer, intent(out) :: status
    status = 1
    if (size(points, 1) /= self%inputs() .or. size(values, 1) /= self%outputs()) return
    if (size(points, 2) /= size(values, 2)) return
    status = c_evaluate(self%handle, size(points, 2, c_size_t), points, values)
  end subroutine

  real(c_double) function scalar(self, name)
    class(seiche_solution), intent(in) :: self
    character(*), intent(in) :: name
    scalar = c_scalar(self%handle, trim(name)//c_null_char)
  end function

  subroutine destroy(self)
    class(seiche_solution), intent(inout) :: self
    call c_free(self%handle)
    self%handle = c_null_ptr
  end subroutine
end module
