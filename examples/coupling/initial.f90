! A solitary wave as initial condition, and a cnoidal wave's surface at an inlet, as a solver in Fortran would ask for them.
program initial
  use, intrinsic :: iso_c_binding, only: c_double
  use seiche
  implicit none
  type(seiche_solution) :: wave, wrong
  real(c_double), allocatable :: points(:, :), values(:, :)
  integer :: k, status

  wave = seiche_create('solitary', 'amplitude=0.1,depth=1,gravity=9.81')
  if (.not. wave%ok()) error stop 'solitary'
  allocate(points(wave%inputs(), 9), values(wave%outputs(), 9))
  do k = 1, 9
    points(:, k) = [2.0_c_double*(k - 5), -0.5_c_double, 0.0_c_double]    ! x, y, t
  end do
  call wave%evaluate(points, values, status)
  if (status /= 0) error stop 'evaluate'
  print '(a, f10.6)', 'speed ', wave%scalar('speed')
  print '(f8.3, 3f12.8)', (points(1, k), values(1:3, k), k=1, 9)          ! eta, u, v
  if (abs(values(1, 5) - 0.1_c_double) > 1e-9_c_double) error stop 'the crest is not as high as asked for'
  if (abs(values(1, 1) - values(1, 9)) > 1e-12_c_double) error stop 'the wave is not symmetric'
  call wave%destroy()

  wave = seiche_create('serre_cnoidal', 'height=0.1,wavelength=12,depth=1,gravity=9.81')
  if (.not. wave%ok()) error stop 'cnoidal'
  print '(a, i0, a)', 'cnoidal wave: ', wave%outputs(), ' outputs'
  call wave%destroy()

  wrong = seiche_create('solitary', 'amplitude=9')
  if (wrong%ok()) error stop 'a wave of nine depths was accepted'
  print '(2a)', 'refused: ', seiche_error()
end program
